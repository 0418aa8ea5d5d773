// Tests of the base normal of a gradient, and of gradients with different bases.
#include <gtest/gtest.h>

#include "lower/check.h"
#include "lower/fixture.h"
#include "lower/lower.h"

namespace wrinkle {
namespace {

using test::graph;

Module lowered_module(const std::string& text, std::string& problems) {
    Diagnostics diagnostics;
    const Project project = test::project(text, diagnostics);
    check(project, test::registry(), Types(project, test::registry()), diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    Lowered result = lower(project, Types(project, test::registry()), {}, diagnostics);
    problems = to_text(diagnostics);
    return std::move(result.module);
}

std::string problems(const std::string& text) {
    std::string found;
    lowered_module(text, found);
    return found;
}

Module lowered_module(const std::string& text) {
    std::string found;
    Module module = lowered_module(text, found);
    EXPECT_EQ(found, "");
    return module;
}

TEST(Bases, AConversionTakesTheBaseItMeets) {
    const Module m = lowered_module(
        graph(R"("h": {"type": "pass_height", "in": {"height": {"from": "surface.facing"}}},
                                      "first": {"type": "resolve", "in": {"gradient": {"from": "h.height"}}},
                                      "on": {"type": "layer", "in": {"base": {"from": "first.normal"},
                                                                     "height": {"from": "surface.facing"}}},
                                      "weak": {"type": "scale", "in": {"gradient": {"from": "h.height"}}},
                                      "sum": {"type": "sum", "in": {"a": {"from": "weak.gradient"},
                                                                    "b": {"from": "on.gradient"}}})",
              R"("normal": {"from": "sum.gradient"}, "first": {"from": "first.normal"})"));
    const Inst& resolve = m[m.outputs[0].value];
    ASSERT_EQ(resolve.op, Op::resolve_);
    const Id base = m[resolve.arg[0]].extra;
    ASSERT_NE(base, poison);
    EXPECT_EQ(m[base].op, Op::base_);
    EXPECT_EQ(m[base].arg[0], m.outputs[1].value);
}

TEST(Bases, UnconstrainedItIsTheSurface) {
    const Module m = lowered_module(
        graph(R"("on": {"type": "layer", "in": {"height": {"from": "surface.facing"}}})",
              R"("normal": {"from": "on.gradient"})"));
    EXPECT_EQ(m[m[m.outputs[0].value].arg[0]].extra, poison);
}

// The wire declares a base, but its value is the surface's own normal: only the value decides.
TEST(Bases, ANormalThatANodeLeavesAsItIsIsTheSurface) {
    const auto text = [](const std::string& amount) {
        return graph(R"("same": {"type": "times", "in": {"amount": )" + amount + R"(}},
"on": {"type": "layer", "in": {"base": {"from": "same.normal"}, "height": {"from": "surface.facing"}}},
"b": {"type": "bump", "in": {"height": {"from": "surface.facing"}}},
"sum": {"type": "sum", "in": {"a": {"from": "b.gradient"}, "b": {"from": "on.gradient"}}})",
                     R"("normal": {"from": "sum.gradient"}, "on": {"from": "on.gradient"})");
    };
    const Module m = lowered_module(text("1"));
    EXPECT_EQ(m[m[m.outputs[1].value].arg[0]].extra, poison);
    EXPECT_NE(problems(text("2")).find("adds gradients of different bases"), std::string::npos);
}

TEST(Bases, TwoInOneSumAreAnErrorWithBothNames) {
    EXPECT_EQ(problems(graph(R"("b": {"type": "bump", "in": {"height": {"from": "surface.facing"}}},
                                "first": {"type": "resolve", "in": {"gradient": {"from": "b.gradient"}}},
                                "on": {"type": "layer", "in": {"base": {"from": "first.normal"},
                                                               "height": {"from": "surface.facing"}}},
                                "sum": {"type": "sum", "in": {"a": {"from": "b.gradient"},
                                                              "b": {"from": "on.gradient"}}})",
                             R"("normal": {"from": "sum.gradient"})")),
              "g.json:5:33: error: node 'sum': adds gradients of different bases: one on the "
              "surface, one on the normal of node 'first' (resolve them one after the other)\n");
}

// Problems of a sum of 'weak' and a layer on a normal that is made from 'weak'.
std::string problems_of_cycle(const std::string& a, const std::string& b) {
    return problems(
        graph(R"("weak": {"type": "scale", "in": {"gradient": {"from": "surface.facing"}}},
"first": {"type": "resolve", "in": {"gradient": {"from": "weak.gradient"}}},
"on": {"type": "layer", "in": {"base": {"from": "first.normal"}, "height": {"from": "surface.facing"}}},
"sum": {"type": "sum", "in": {"a": {"from": ")" +
                  a + R"("}, "b": {"from": ")" + b + R"("}}})",
              R"("normal": {"from": "sum.gradient"})"));
}

constexpr std::string_view cycle =
    "g.json:1:26: error: node 'weak': its gradient would be based on the normal of node 'first', "
    "which "
    "is made from it; node 'on' says that base (use a node of its own for each of the two bases)\n";

TEST(Bases, AGradientCannotStandOnANormalMadeFromIt) {
    const std::string text = problems_of_cycle("on.gradient", "weak.gradient");
    EXPECT_NE(text.find(cycle), text.npos) << text;
}

TEST(Bases, ThatIsAnErrorFromBothEndsOfTheCycle) {
    const std::string text = problems_of_cycle("weak.gradient", "on.gradient");
    EXPECT_NE(text.find(cycle), text.npos) << text;
}

TEST(Bases, AnInputOfTheGraphIsNotIgnored) {
    const std::string text =
        graph(R"("on": {"type": "layer", "in": {"base": {"from": "input.n"}}},
"weak": {"type": "scale", "in": {"gradient": {"from": "surface.facing"}}},
"sum": {"type": "sum", "in": {"a": {"from": "weak.gradient"}, "b": {"from": "on.gradient"}}})",
              R"("normal": {"from": "sum.gradient"})",
              R"("inputs": {"n": {"type": "normal", "default": [0, 0, 1]}}, )");
    Diagnostics diagnostics;
    const Project project = test::project(text, diagnostics);
    EXPECT_FALSE(compile_material(project, test::registry(), {}, diagnostics).ok);
    EXPECT_NE(to_text(diagnostics)
                  .find("error: node 'on': the base is neither the surface's "
                        "normal nor the output of a resolve"),
              std::string::npos)
        << to_text(diagnostics);
}

}  // namespace
}  // namespace wrinkle
