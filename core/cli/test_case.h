// Regression cases of a graph NAME.json, read from NAME.test.json in the same folder. They are
// documented in docs/test-cases.md. All keys are optional; unknown keys are errors.
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
    std::string name;             // NAME
    std::vector<std::string> set;
    PointList points;
    json::Value expect;  // null: not given
    double tolerance_deg = 0.05;
    double tolerance = 1e-4;
    bool glsl = false;
    std::optional<RenderCase> render;
    std::string text;  // contents of `file`

    std::filesystem::path golden(const std::string& extension) const;
};

// JSON Schema of test files, which `wrinkle test --schema` prints.
std::string case_schema();

// Reads the keys of a test file into `test` and reports problems at their values. If `updating` is
// set, `expect` and `points` may differ in length.
void read_case_keys(const json::Value& root, bool updating, TestCase& test,
                    Diagnostics& diagnostics);

// Returns std::nullopt and reports a problem on failure.
std::optional<TestCase> read_test_case(const std::filesystem::path& file, bool updating,
                                       Diagnostics& diagnostics);

// Returns the file's text with "expect" replaced by `entries`; all else is unchanged.
std::string with_expect(const TestCase& test, const std::vector<std::string>& entries);

// Returns the given test files in order; a folder is replaced by all tests below it, sorted by
// name.
std::vector<std::filesystem::path> find_tests(const std::vector<std::string>& paths,
                                              Diagnostics& diagnostics);

}  // namespace wrinkle::cli
