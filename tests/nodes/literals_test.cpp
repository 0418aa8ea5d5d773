// Tests that numbers which are literals while nodes are built decide nothing that parameters do
// not.
#include <gtest/gtest.h>

#include "emit/emit.h"
#include "graph/subgraph.h"
#include "lower/material.h"
#include "support/linked_nodes.h"

namespace wrinkle {
namespace {

using test::linked_nodes;

struct Result {
    std::string text, problems;
    bool has(std::string_view word) const { return text.find(word) != text.npos; }
};

Result compiled(const std::string& nodes, bool uniform) {
    const std::string text = R"({"wrinkle": 1, "nodes": {)" + nodes +
                             R"(}, "outputs": {"normal": {"from": "end.normal"}}})";
    Result result;
    Diagnostics diagnostics;
    const Project project =
        load_project(read_document(text, "test.json", diagnostics),
                     std::filesystem::path(WRINKLE_SOURCE_DIR) / "graphs", {}, diagnostics);
    MaterialOptions options;
    options.uniform_parameters = uniform;
    const Compiled material = compile_material(project, linked_nodes(), options, diagnostics);
    if (material.ok) result.text = emit(material.module, {}).source;
    result.problems = to_text(diagnostics);
    return result;
}

// uv0 moved by a component of uv1 times `factor`.
std::string moved_uv(const std::string& factor) {
    return R"("one": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv1"}}},
        "part": {"type": "multiply", "in": {"a": {"from": "one.x"}, "b": )" +
           factor + R"(}},
        "zero": {"type": "separate_vec2", "in": {"vector": {"from": "surface.uv0"}}},
        "x": {"type": "add", "in": {"a": {"from": "zero.x"}, "b": {"from": "part.result"}}},
        "uv": {"type": "combine_vec2", "in": {"x": {"from": "x.result"},
                                              "y": {"from": "zero.y"}}},)";
}

std::string map_and_end(const std::string& more) {
    return R"("map": {"type": "tangent_normal_map", "in": {"image": "textures/weave_normal.png",
              "uv": {"from": "uv.vector"})" +
           more + R"(}}, "end": {"type": "resolve", "in": {"gradient": {"from": "map.gradient"}}})";
}

TEST(Literals, AFrameFollowsFromWhatAFactorOfZeroHides) {
    for (const std::string factor : {"0", "2"})
        for (const bool uniform : {false, true}) {
            const Result result = compiled(moved_uv(factor) + map_and_end(""), uniform);
            EXPECT_EQ(result.problems, "");
            EXPECT_NE(result.text, "");
            // A uv made of two sets has a separate frame, different from vertex tangents.
            EXPECT_FALSE(result.has("s.tangent")) << factor << result.text;
        }
}

TEST(Literals, WhatIsHiddenFromAnotherNodeHidesNothingHere) {
    const std::string plain = R"("uv": {"type": "combine_vec2", "in": {
        "x": {"from": "zero.x"}, "y": {"from": "zero.y"}}},)";
    const std::string both = moved_uv("0") + map_and_end("");
    const size_t begin = both.find("\"uv\":");
    const std::string other = both.substr(0, begin) + plain + both.substr(both.find("\"map\""));
    EXPECT_TRUE(compiled(other, false).has("s.tangent"));
    EXPECT_TRUE(compiled(other, true).has("s.tangent"));
}

TEST(Literals, AFrameThatDoesNotFitIsAnErrorWhateverItsFactor) {
    const std::string wrong = map_and_end(R"(, "frame": "vertex")");
    const std::string scaled =
        R"("map": {"type": "tangent_normal_map", "in": {"image": "textures/weave_normal.png",
              "uv": {"from": "uv.vector"}, "frame": "vertex"}},
           "none": {"type": "gradient_scale", "in": {"gradient": {"from": "map.gradient"},
                                                     "amount": 0}},
           "end": {"type": "resolve", "in": {"gradient": {"from": "none.gradient"}}})";
    for (const std::string& nodes :
         {moved_uv("0") + wrong, moved_uv("2") + wrong, moved_uv("2") + scaled}) {
        const Result baked = compiled(nodes, false), uniform = compiled(nodes, true);
        EXPECT_NE(baked.problems.find("the frame 'vertex' needs a uv"), std::string::npos) << nodes;
        EXPECT_EQ(baked.problems, uniform.problems);
    }
}

// A bump on a mix of the surface's normal and a resolved one; an amount of 0 leaves only the first,
// but the base does not depend on the amount.
std::string bump_on_mixed(const std::string& smooth, const std::string& bumped) {
    const auto from = [](const std::string& name) {
        return name.empty() ? "" : ", \"" + name + R"(": {"from": "first.normal"})";
    };
    return R"("below": {"type": "tangent_normal_map",
                  "in": {"image": "textures/rivets_normal.png"}},
        "first": {"type": "resolve", "in": {"gradient": {"from": "below.gradient"}}},
        "mixed": {"type": "compare_blender_strength", "in": {"amount": 0)" +
           from(smooth) + from(bumped) + R"(}},
        "bump": {"type": "gradient_from_height", "in": {"height": {"from": "surface.facing"},
                 "base": {"from": "mixed.normal"}}},
        "end": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}})";
}

TEST(Literals, ABaseIsNotTheSurfaceByAValue) {
    const std::string nodes = bump_on_mixed("", "bumped");
    const Result baked = compiled(nodes, false), uniform = compiled(nodes, true);
    EXPECT_NE(baked.problems.find("the base is neither"), std::string::npos) << baked.text;
    EXPECT_EQ(baked.problems, uniform.problems);
}

TEST(Literals, ABaseIsNotAResolvedNormalByAValue) {
    const std::string nodes = bump_on_mixed("smooth", "");
    const Result baked = compiled(nodes, false), uniform = compiled(nodes, true);
    EXPECT_NE(baked.problems.find("the base is neither"), std::string::npos) << baked.text;
    EXPECT_EQ(baked.problems, uniform.problems);
}

}  // namespace
}  // namespace wrinkle
