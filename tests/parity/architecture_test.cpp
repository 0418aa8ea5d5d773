// The prints of docs/architecture.md are those of the graph on that page.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <sstream>

#include "certify/compare.h"
#include "emit/emit.h"
#include "graph/read.h"
#include "ir/expand.h"
#include "ir/inspect.h"
#include "ir/rewrite.h"
#include "lower/material.h"
#include "parity/node_graph.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

// The fenced blocks of a page, in order.
std::vector<std::string> fenced_blocks(const std::string& page) {
    std::vector<std::string> blocks;
    constexpr std::string_view fence = "\n```";
    for (size_t open = page.find(fence); open != page.npos;) {
        const size_t begin = page.find('\n', open + 1) + 1;
        const size_t end = page.find(fence, begin - 1);
        blocks.push_back(page.substr(begin, end + 1 - begin));
        open = page.find(fence, end + 1);
    }
    return blocks;
}

// The lines without ids, sorted: the order of evaluation of arguments is the compiler's choice, so
// ids are.
std::vector<std::string> without_ids(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        std::string plain;
        for (size_t i = 0; i < line.size(); ++i)
            if (i == 0 || line[i - 1] != '%' || !std::isdigit(static_cast<unsigned char>(line[i])))
                plain += line[i];
            else
                while (i + 1 < line.size() && std::isdigit(static_cast<unsigned char>(line[i + 1])))
                    ++i;
        lines.push_back(plain);
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

// uv0.x grows by one per unit of length along x.
PointSet point_of_the_page() {
    PointSet points;
    points.count = 1;
    points.at(SurfaceInput::normal_) = {0, 0, 1};
    points.at(SurfaceInput::facing_) = {1};
    points.at(SurfaceInput::position_, Variant::dx) = {0.01, 0, 0};
    points.at(SurfaceInput::position_, Variant::dy) = {0, 0.01, 0};
    points.at(SurfaceInput::uv0_, Variant::dx) = {0.01, 0};
    points.at(SurfaceInput::uv0_, Variant::dy) = {0, 0.01};
    return points;
}

TEST(Architecture, PrintsOfThePageAreThoseOfItsGraph) {
    const auto blocks = fenced_blocks(bytes_of(WRINKLE_SOURCE_DIR "/docs/architecture.md"));
    ASSERT_EQ(blocks.size(), 5U);
    Diagnostics diagnostics;
    const Project project =
        load_project(read_document(blocks[0], "softer.json", diagnostics), ".", {}, diagnostics);
    const Module lowered = lower(project, Types(project, all_nodes()), {}, diagnostics).module;
    EXPECT_EQ(print(lowered), blocks[1]);
    const Module expanded = expand(lowered, {.parameters = Parameters::baked});
    EXPECT_EQ(without_ids(print(expanded)), without_ids(blocks[2]));
    EmitOptions options;
    options.name = "softer";
    EXPECT_NE(emit(expanded, options).source.find(blocks[3]), std::string::npos);
    std::string why;
    const auto values =
        certify::on_cpu<double>(explicit_lod(expanded), point_of_the_page(), test_image, why);
    ASSERT_TRUE(values) << why;
    const auto& normal = values->at(0);
    char line[80];
    std::snprintf(line, sizeof line, "normal = %.6g %.6g %.6g\n", normal[0], normal[1], normal[2]);
    EXPECT_EQ(line, blocks[4]);
    EXPECT_EQ(to_text(diagnostics), "");
}

}  // namespace
}  // namespace wrinkle::test
