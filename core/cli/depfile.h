// Make-style dependency files, as compilers write them with -MD -MF -MT -MP.
#pragma once

#include <string>
#include <vector>

#include "cli/cli.h"

namespace wrinkle::cli {

struct Depfile {
    bool wanted = false;
    bool phony = false;  // inputs are targets of their own, so that one may be removed
    std::string path;    // "": the output's name with ".d"
    std::string target;  // "": the outputs
};

void declare_depfile(CLI::App& command, Depfile& depfile);

// What one graph made, and from what.
struct Rule {
    std::vector<std::string> made, from;
};

// Why these rules cannot be written, a sentence; "" when they can. A dependency file holds names
// that Make 4.3 and Ninja 1.11 read alike: none with a control character or one of "&'*;<=>?^`| in
// it, with a backslash before a character that is escaped or at its end, with ~ at its beginning,
// or a blank or a colon at its end; the name of a target holds no %.
std::string depfile_fault(const std::vector<Rule>& rules, const Depfile& depfile);

// "a b: c \<newline>  d" of each graph, names escaped for Make and Ninja. With a target of the
// user's own it is one rule of all. Only of rules without a fault.
std::string make_rules(const std::vector<Rule>& rules, const Depfile& depfile);

}  // namespace wrinkle::cli
