// Regression cases of a graph NAME.json, read from NAME.test.json in the same folder. They are
// documented in docs/test-cases.md. All keys are optional; unknown keys are errors. A file has the
// cases of its top-level keys and those of each entry of "cases"; an entry has other values of
// --preset and --set.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/comparison.h"
#include "cli/offscreen_renderer.h"
#include "cli/points.h"
#include "cli/test_budget.h"
#include "json/value.h"

namespace wrinkle::cli {

struct RenderCase {
    RenderOptions options;
    json::Value value;  // for messages
    json::Value mesh;   // for messages; null: not given
    std::string metric = "rms";
    std::optional<double> tolerance;  // limit of the mean; default: default_tolerance(metric)
    std::optional<double> max_pixel;  // limit of every pixel
    double over = 0;                  // pixels above this value are counted
    std::optional<double> max_over;   // limit of that count
};

// The default limit of the mean of a metric.
double default_tolerance(std::string_view metric);

struct TestCase {
    std::filesystem::path file;   // NAME.test.json
    std::filesystem::path graph;  // NAME.json
    std::string name;             // NAME, or NAME.ENTRY for an entry of "cases"
    std::string entry;            // name of that entry; "": the file's own keys
    std::string preset;
    std::vector<std::string> set;
    PointList points;
    json::Value expect;  // null: not given
    double tolerance_deg = 0.05;
    double tolerance = 1e-4;
    bool glsl = false;
    std::optional<RenderCase> render;
    std::vector<BudgetLimit> budget;
    json::Value budget_value;  // for messages
    json::Value object;        // value with the keys of this case
    std::string text;          // contents of `file`

    std::filesystem::path golden(const std::string& extension) const;
    std::vector<std::filesystem::path> golden_files() const;  // those that its checks read
    // "graphs/rings.old": near_path() of the test file without ".test.json", and the entry.
    std::string full_name() const;
    std::string flat_name() const;  // full_name() as part of a file name: "graphs-rings.old"
};

// Returns the folder that the files of a test must be below: --root, or that of its file.
std::filesystem::path root_of(const TestCase& test, const CommonOptions& common);

// Returns the normal form of `path`, relative to the working folder if it is below it.
std::filesystem::path near_path(const std::filesystem::path& path);

// JSON Schema of test files, which `wrinkle test --schema` prints.
std::string case_schema();

// Returns the cases of a test file: `file_case` with the keys of the root if they define a case,
// then one for each entry of "cases". Reports problems at their values.
std::vector<TestCase> read_case_keys(const json::Value& root, TestCase file_case,
                                     Diagnostics& diagnostics);

// Returns no cases and reports a problem on failure.
std::vector<TestCase> read_test_cases(const std::filesystem::path& file, Diagnostics& diagnostics);

struct TestFile {
    std::filesystem::path path;
    std::vector<TestCase> cases;
    Diagnostics problems;  // from reading; `cases` is empty if it has errors
};
TestFile read_test_file(const std::filesystem::path& path);

// Returns the text of a parsed array or object as in its file.
std::string container_text(const json::Value& container);

// Returns the file's text with "expect" of the case replaced by `entries`; all else is unchanged.
std::string with_expect(const TestCase& test, const std::vector<std::string>& entries);

// Returns the given test files in order; a folder is replaced by all tests below it, sorted by
// name.
std::vector<std::filesystem::path> find_tests(const std::vector<std::string>& paths,
                                              Diagnostics& diagnostics);

}  // namespace wrinkle::cli
