// Tests of the attribution of instruction costs.
#include "cost/report.h"

#include <gtest/gtest.h>

#include "ir/op.h"
#include "json/parse.h"

namespace wrinkle::test {
namespace {

// A function over five lines: a line of the surface point, one of node 1, two of node 2.
Shader small_shader() {
    Shader shader;
    shader.source = "struct S {\n    vec3 normal;\n};\nvec3 f(S s) {\n    return s.normal;\n}\n";
    Reflection& r = shader.reflection;
    r.struct_name = "S";
    r.members = {{"normal", Type::vec3_}};
    OutputInfo& output = r.outputs.emplace_back();
    output.output = "normal";
    output.type = Type::vec3_;
    r.function = "f";
    r.lines = {no_node, 0, 1, 2, 2, no_node};
    r.node_paths = {"", "weave", "strap/tilt"};
    return shader;
}

TEST(CostReport, LinesBelongToTheirNodes) {
    SpirvCount count;
    uint32_t numbers = 1;
    for (ShaderCost& line : count.lines = std::vector<ShaderCost>(5)) {
        line.alu = numbers;
        count.total += line;
        numbers *= 2;
    }
    const CostReport report = cost_report(small_shader(), count);
    ASSERT_EQ(report.nodes.size(), 2U);
    EXPECT_EQ(report.nodes[0].node, "strap/tilt");
    EXPECT_EQ(report.nodes[0].cost.alu, 8U);
    EXPECT_EQ(report.nodes[1].node, "weave");
    EXPECT_EQ(report.nodes[1].cost.alu, 4U);
    EXPECT_EQ(report.shared.alu, 1U + 2U + 16U);
    EXPECT_EQ(report.total.alu, 31U);
}

CostReport small_report() {
    CostReport report;
    report.total = {.alu = 64, .transcendental = 1, .divisions = 2, .reads = 3};
    report.once = report.total;
    report.nodes = {{"strap/tilt", {.alu = 60, .divisions = 2, .reads = 3}, 2},
                    {"weave", {.alu = 3}, 0}};
    report.shared = {.alu = 1};
    report.texture_units = 2;
    return report;
}

TEST(CostReport, IsATable) {
    EXPECT_EQ(to_text(small_report()),
              R"(   ALU  div  reads  derivs  units  node
    64    2      3       0      2  in all, 2 of 16 texture units
    60    2      3       0      2  strap/tilt
     3    0      0       0      0  weave
     1    0      0       0      0  (the surface point)
)");
}

TEST(CostReport, IsJson) {
    Diagnostics problems;
    const json::Value report = json::parse(to_json(small_report()), "cost", problems).root;
    ASSERT_FALSE(problems.has_errors()) << to_json(small_report());
    EXPECT_EQ(report.find("total").find("alu").as_number(), 64);
    EXPECT_EQ(report.find("total").find("transcendental").as_number(), 1);
    EXPECT_EQ(report.find("total").find("texture_units").as_number(), 2);
    ASSERT_EQ(report.find("nodes").size(), 2u);
    EXPECT_EQ(report.find("nodes").at(0).find("node").as_string(), "strap/tilt");
    EXPECT_EQ(report.find("nodes").at(0).find("texture_reads").as_number(), 3);
    EXPECT_EQ(report.find("surface_point").find("alu").as_number(), 1);
}

TEST(CostReport, AnImageIsAUnitOfEachNodeThatReadsIt) {
    Shader shader = small_shader();
    SamplerInfo& first = shader.reflection.samplers.emplace_back();
    first.readers = {{"weave", "image"}, {"weave", "mask"}, {"strap/tilt", "image"}};
    shader.reflection.samplers.emplace_back().readers = {{"weave", "image"}};
    SpirvCount count;
    count.lines = {{}, {}, {.alu = 1}, {.alu = 2}};
    const CostReport report = cost_report(shader, count);
    ASSERT_EQ(report.nodes.size(), 2U);
    EXPECT_EQ(report.nodes[0].texture_units, 1U);
    EXPECT_EQ(report.nodes[1].texture_units, 2U);
    EXPECT_EQ(report.texture_units, 2U);
}

}  // namespace
}  // namespace wrinkle::test
