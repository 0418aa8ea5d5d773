// Requirements on the program with hostile input, checked after every run.
//
// A run ends within five seconds with exit code 0, 1, 2 or 3. It prints and writes valid UTF-8
// without control characters, creates only the files that the command line names as outputs, and
// never shows contents from outside of the project's root.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cli/support.h"

namespace wrinkle::hostile {

using test::CliTest;
using test::Ran;
namespace fs = std::filesystem;

// Content of a file outside of the root.
inline constexpr const char* secret = "SECRET-CONTENT";

// Returns the first character that a terminal or an editor interprets instead of showing it (a
// control character except line feed and tab, a bidirectional or line-separating one), as "U+001B
// at byte 5", or the first byte that is not UTF-8; "" if there is none.
std::string unsafe_character(std::string_view text);

class HostileTest : public CliTest {
protected:
    void SetUp() override;

    // Runs the program and reports violations of the requirements as failures named `label`. Files
    // that the run creates must be in `outputs` or below a folder of them.
    Ran attack(const std::string& label, const std::vector<std::string>& args,
               const std::set<std::string>& outputs = {}, const std::string& input = "");

    // Removes `outputs` and all files that are not part of the project; see baseline().
    void clean();
    // Records the current files as the project; clean() does not remove them.
    void baseline();

    size_t cases = 0;

private:
    std::string violation(const Ran& ran, const std::set<std::string>& outputs);
    std::vector<std::string> all_files() const;

    std::set<std::string> project_;
};

}  // namespace wrinkle::hostile
