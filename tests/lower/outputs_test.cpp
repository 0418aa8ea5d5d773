// Tests of the outputs of a lowered graph: chosen by name, under both names.
#include <gtest/gtest.h>

#include "lower/fixture.h"

namespace wrinkle {
namespace {

using test::graph;
using test::lowered;
using test::value;

TEST(Outputs, OutputsCanBeChosen) {
    Diagnostics diagnostics;
    const Project project =
        test::project(graph(R"("n": {"type": "number"}, "o": {"type": "options"})",
                            R"("a": {"from": "n.value"}, "bee": {"from": "o.value"})"),
                      diagnostics);
    LowerOptions options;
    options.outputs = {"bee"};
    const Module m = lowered(project, options).module;
    ASSERT_EQ(m.outputs.size(), 1u);
    EXPECT_EQ(m.outputs[0].name, "bee");
    EXPECT_EQ(m.nodes.size(), 2u);
    options.outputs = {"be"};
    lower(project, Types(project, test::registry()), options, diagnostics);
    EXPECT_EQ(to_text(diagnostics),
              "g.json: error: the graph has no output 'be' (did you mean 'bee'?)\n");
}

TEST(Outputs, StandardOutputsHaveTwoNames) {
    Diagnostics diagnostics;
    const Project project = test::project(
        graph(R"("n": {"type": "number"})",
              R"("base_color": {"from": "n.value"}, "fuzz_weight": {"from": "n.value"})"),
        diagnostics);
    LowerOptions options;
    options.outputs = {"color"};
    const Module m = lowered(project, options).module;
    ASSERT_EQ(m.outputs.size(), 1u);
    EXPECT_EQ(m.outputs[0].name, "color");
    EXPECT_EQ(m.outputs[0].port_type, uint32_t{WR_PORT_color});
    EXPECT_EQ(value(m, 0).op, Op::construct_);
    options.outputs = {"base_color", "fuzz_weight"};
    EXPECT_EQ(lowered(project, options).module.outputs.size(), 2u);
}

}  // namespace
}  // namespace wrinkle
