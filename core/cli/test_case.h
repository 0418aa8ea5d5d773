// Regression cases of a graph NAME.json, read from NAME.test.json in the same folder. They are
// documented in docs/test-cases.md. All keys are optional; unknown keys are errors. A file has the
// cases of its top-level keys and those of each entry of "cases"; an entry has other values of
// --preset and --set.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/offscreen_renderer.h"
#include "cli/points.h"
#include "json/value.h"

namespace wrinkle::cli {

struct RenderCase {
    RenderOptions options;
    json::Value mesh;  // value of the key, for messages; null: not given
    double tolerance = 1;
};

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
    json::Value object;  // value with the keys of this case
    std::string text;    // contents of `file`

    std::filesystem::path golden(const std::string& extension) const;
};

// JSON Schema of test files, which `wrinkle test --schema` prints.
std::string case_schema();

// Returns the cases of a test file: `file_case` with the keys of the root if they define a case,
// then one for each entry of "cases". Reports problems at their values. If `updating` is set,
// `expect` and `points` may differ in length.
std::vector<TestCase> read_case_keys(const json::Value& root, bool updating, TestCase file_case,
                                     Diagnostics& diagnostics);

// Returns no cases and reports a problem on failure.
std::vector<TestCase> read_test_cases(const std::filesystem::path& file, bool updating,
                                      Diagnostics& diagnostics);

// Returns the file's text with "expect" replaced by `entries`; all else is unchanged.
std::string with_expect(const TestCase& test, const std::vector<std::string>& entries);

// Returns the given test files in order; a folder is replaced by all tests below it, sorted by
// name.
std::vector<std::filesystem::path> find_tests(const std::vector<std::string>& paths,
                                              Diagnostics& diagnostics);

}  // namespace wrinkle::cli
