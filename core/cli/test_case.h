// Regression cases of a graph NAME.json, from NAME.test.json beside it. docs/test-cases.md is their
// reference; cli/test_schema.h has their keys. Every key may be left out; unknown ones are errors.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/graph_files.h"
#include "cli/picture.h"
#include "cli/points.h"
#include "json/value.h"

namespace wrinkle::cli {

struct RenderCase {
    PictureOptions picture;
    json::Value mesh;  // where it is named; null: not given
    double tolerance = 1;
};

struct TestCase {
    std::filesystem::path file;   // NAME.test.json
    std::filesystem::path graph;  // NAME.json
    std::string name;             // NAME
    std::vector<std::string> set;
    std::vector<Point> points;
    json::Value expect;  // null: not given
    double tolerance_deg = 0.05;
    double tolerance = 1e-4;
    bool glsl = false;
    std::optional<RenderCase> render;
    std::string text;  // of the file

    std::filesystem::path golden(const std::string& extension) const;
};

// Nothing with a problem reported. With `updating`, `expect` may have another length than points.
std::optional<TestCase> read_test_case(const std::filesystem::path& file, bool updating,
                                       Diagnostics& diagnostics);

// The file's text with these entries as its "expect"; nothing else changes.
std::string with_expect(const TestCase& test, const std::vector<std::string>& entries);

// Files as given and those below folders, in the order of their names.
std::vector<std::filesystem::path> find_tests(const std::vector<std::string>& paths,
                                              Diagnostics& diagnostics);

}  // namespace wrinkle::cli
