// Runs regression cases, one file after the other.
#pragma once

#include <filesystem>
#include <string>

#include "cli/evaluation.h"
#include "cli/test_case.h"

namespace wrinkle::cli {

// Returns one sentence per output of the point that differs from `expected` (an object) or that
// cannot be compared; empty if all are equal within the tolerances. `document` provides the node of
// each output, for messages.
std::vector<std::string> differences(const TestCase& test, const Document& document,
                                     const json::Value& expected,
                                     const std::vector<OutputColumn>& columns, size_t point);

// Returns the RMS difference over all channels in 8-bit steps; negative if the sizes differ.
double image_difference(const Image& expected, const Image& got);

struct TestOptions {
    bool update = false;
    std::string report;  // folder; "": none
};

struct TestTally {
    size_t passed = 0;
    size_t failed = 0;
    std::string environment;  // why a run or a write failed, one sentence; exit code 3
};

class TestRun {
public:
    TestRun(const Registry& registry, const CommonOptions& common, const TestOptions& options)
        : registry_(registry), common_(common), options_(options) {}

    // Runs a file and prints its failures. A file that cannot run counts as one failed case, and
    // its problems are reported.
    void test(const std::filesystem::path& file, Diagnostics& diagnostics);
    const TestTally& tally() const { return tally_; }
    // Failures of cases that ran, as problems: file, JSON pointer of the case, sentence.
    const Diagnostics& failures() const { return failures_; }

private:
    void run(const TestCase& test, Diagnostics& diagnostics);
    void conclude(const std::string& title, const Diagnostics& own, Diagnostics& diagnostics);
    std::string preset_of(const TestCase& test, Diagnostics& diagnostics);
    void refuse_outside(const std::filesystem::path& file, const TestCase& test,
                        Diagnostics& diagnostics);
    bool may_report(const TestCase& test, const std::filesystem::path& golden);
    void values(const TestCase& test, const MaterialRun& run, const TextureStore& textures,
                Diagnostics& diagnostics);
    void update_values(const TestCase& test, const std::vector<OutputColumn>& columns,
                       const std::vector<bool>& differs);
    void text(const TestCase& test, const Shader& shader);
    void image(const TestCase& test, const Shader& shader, const Mesh& still,
               const std::optional<Mesh>& moved, const TextureStore& textures,
               Diagnostics& diagnostics);
    bool write(const std::filesystem::path& path, std::string_view bytes);
    bool save(const Image& image, const std::filesystem::path& path);
    std::filesystem::path report_path(const TestCase& test, const std::string& extension) const;
    void pass() { ++tally_.passed; }
    void fail(const TestCase& test, const json::Value& place, const char* pointer,
              const std::string& sentence);

    const Registry& registry_;
    const CommonOptions& common_;
    const TestOptions& options_;
    TestTally tally_;
    Diagnostics failures_;
};

}  // namespace wrinkle::cli
