// Tests of fields that are read elsewhere: a large one is a function, so that chains of nodes that
// read fields grow with their length, and it has the numbers of copies.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>

#include "certify/subject.h"
#include "chains/chain.h"
#include "cpu/evaluate.h"
#include "emit/emit.h"
#include "graph/read.h"
#include "graph/subgraph.h"
#include "lower/material.h"

namespace wrinkle::test {
namespace {

Compiled compiled(const std::string& text, const MaterialOptions& options, Diagnostics& problems) {
    std::string why;
    const auto folder = certify::make_image_folder(why);
    EXPECT_TRUE(folder) << why;
    const Project project = load_project(
        read_document(text, (*folder / "graph.json").string(), problems), *folder, {}, problems);
    return compile_material(project, registry(), options, problems);
}

struct Size {
    size_t values = 0, lines = 0;
};

Size size_of_chain(const std::string& first, const std::string& second, int length) {
    const NodeType *a = registry().find(first), *b = registry().find(second);
    const Link there = link(*a, *b, Wiring::one_input), back = link(*b, *a, Wiring::one_input);
    Diagnostics problems;
    const Compiled made = compiled(chain(there, back, length), {}, problems);
    EXPECT_TRUE(made.ok) << first << ", " << second << ": " << to_text(problems);
    if (!made.ok) return {};
    const std::string source = emit(made.module, {}).source;
    return {made.module.size(), static_cast<size_t>(std::ranges::count(source, '\n'))};
}

// Lines may grow by the arguments of calls, which the functions of all former nodes need.
TEST(Fields, ChainsGrowWithTheirLength) {
    const std::vector<std::string> readers = {"parallax_offset", "parallax_occlusion",
                                              "triplanar_height"};
    std::vector<std::string> others = {"height_add", "add",        "gradient_noise",
                                       "scratches",  "height_map", "hex_tile_height_map"};
    others.insert(others.end(), readers.begin(), readers.end());
    for (const std::string& reader : readers)
        for (const std::string& other : others) {
            SCOPED_TRACE(reader + ", " + other);
            const Size ten = size_of_chain(reader, other, 10);
            const Size twenty = size_of_chain(reader, other, 20);
            const Size thirty = size_of_chain(reader, other, 30);
            EXPECT_LT(thirty.values - twenty.values, 1.5 * (twenty.values - ten.values) + 100);
            EXPECT_LT(thirty.lines - twenty.lines, 1.7 * (twenty.lines - ten.lines) + 100);
            EXPECT_LT(thirty.values, 200U * 30);
        }
}

// The number of operations doubles with each node where a function is called twice.
TEST(Fields, WhatRunsWithoutFunctionsIsRefusedAtOnce) {
    const NodeType* type = registry().find("parallax_offset");
    const Link same = link(*type, *type, Wiring::one_input);
    MaterialOptions options;
    options.runs_calls = "eval";
    Diagnostics problems;
    const auto start = std::chrono::steady_clock::now();
    EXPECT_FALSE(compiled(chain(same, same, 30), options, problems).ok);
    EXPECT_NE(to_text(problems).find("node 'n29': eval would make more than 4000000 operations"),
              std::string::npos)
        << to_text(problems);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(2));
}

std::string waves(const std::string& id, int number) {
    return "\"" + id +
           "\": {\"type\": \"waves\", \"in\": {\"direction\": " + std::to_string(10 * number) +
           ", \"phase\": 0." + std::to_string(number) + "}},\n";
}

std::string node(const std::string& id, const std::string& type, const std::string& inputs) {
    return "\"" + id + "\": {\"type\": \"" + type + "\", \"in\": {" + inputs + "}},\n";
}

std::string from(const std::string& port, const std::string& node) {
    return "\"" + port + "\": {\"from\": \"" + node + "\"}";
}

// The sum of waves read as one field, or the sum of fields of one wave each.
std::string graph_of_waves(int count, bool one_field) {
    std::string text = "{\"wrinkle\": 1, \"nodes\": {\n", sum;
    for (int i = 0; i < count; ++i) {
        const std::string wave = "w" + std::to_string(i), tiled = "t" + std::to_string(i);
        std::string height = wave + ".height";
        text += waves(wave, i);
        if (!one_field) {
            text += node(tiled, "triplanar_height", from("height", height));
            height = tiled + ".height";
        }
        if (i > 0)
            text += node("s" + std::to_string(i), "height_add",
                         from("a", sum) + ", " + from("b", height));
        sum = i > 0 ? "s" + std::to_string(i) + ".height" : height;
    }
    if (one_field) text += node("all", "triplanar_height", from("height", sum));
    if (one_field) sum = "all.height";
    text += node("bump", "gradient_from_height", from("height", sum));
    text += node("shaded", "resolve", from("gradient", "bump.gradient"));
    text.erase(text.rfind(','));
    return text + "},\n\"outputs\": {" + from("height", sum) + ", " +
           from("normal", "shaded.normal") + "}}";
}

// `function`: the module has a function of the field.
Results evaluated(const std::string& graph, bool& function) {
    constexpr size_t count = 50;
    MaterialOptions options;
    options.given_differentials = true;
    Diagnostics problems;
    const Compiled made = compiled(graph, options, problems);
    EXPECT_TRUE(made.ok) << to_text(problems);
    function = false;
    for (uint32_t i = 0; i < made.module.region_count(); ++i)
        function = function || made.module.region(i).name.starts_with("height");
    std::string why;
    const Program program = compile_program(made.module, why);
    PointSet points;
    points.count = count;
    for (const InputNeed& need : needed_inputs(program)) {
        std::vector<double>& values = points.at(need.input, need.variant);
        values.resize(count * info(info(need.input).type).lanes);
        for (size_t k = 0; k < values.size(); ++k)
            values[k] = (need.variant == Variant::value ? 1 : 0.01) *
                        (static_cast<double>(k * 2654435761U % 1009) / 504 - 1);
    }
    Results results = make_results(program, count);
    evaluate<double>(program, points, {}, 0, count, results);
    return results;
}

TEST(Fields, AFunctionHasTheNumbersOfCopies) {
    bool function = false, copies = true;
    const Results one = evaluated(graph_of_waves(8, true), function);
    const Results many = evaluated(graph_of_waves(8, false), copies);
    EXPECT_TRUE(function);
    EXPECT_FALSE(copies);
    for (size_t output = 0; output < one.values.size(); ++output)
        for (size_t k = 0; k < one.values[output].size(); ++k)
            EXPECT_NEAR(one.values[output][k], many.values[output][k], 1e-12);
}

}  // namespace
}  // namespace wrinkle::test
