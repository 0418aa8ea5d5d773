// Who an instruction's cost is put down to.
#include "cost/report.h"

#include <gtest/gtest.h>

namespace wrinkle::test {
namespace {

// Two functions over five lines: a line of the surface point, one of node 1, two of node 2.
Shader small_shader() {
    Shader shader;
    shader.source = "struct S {\n    vec3 normal;\n};\nvec3 f(S s) {\n    return s.normal;\n}\n";
    Reflection& r = shader.reflection;
    r.struct_name = "S";
    r.members = {{"normal", Type::vec3_}};
    FunctionInfo& function = r.functions.emplace_back();
    function.output = "normal";
    function.function = "f";
    r.lines = {no_node, 0, 1, 2, 2, no_node};
    r.node_paths = {"", "weave", "strap/tilt"};
    return shader;
}

TEST(CostReport, TheShaderCallsEveryFunctionOnInterpolants) {
    const CountedShader counted = counted_shader(small_shader());
    EXPECT_EQ(counted.text, R"(#version 450
layout(location = 0) in vec3 counted_normal;
layout(location = 0) out vec3 counted_normal_out;
struct S {
    vec3 normal;
};
vec3 f(S s) {
    return s.normal;
}

void main() {
    S surface;
    surface.normal = counted_normal;
    counted_normal_out = f(surface);
}
)");
    EXPECT_EQ(counted.lines_before, 3U);
}

TEST(CostReport, AFunctionWithoutArguments) {
    Shader shader = small_shader();
    shader.source = "vec3 f() {\n    return vec3(1.0);\n}\n";
    shader.reflection.struct_name = "";
    shader.reflection.members.clear();
    EXPECT_NE(counted_shader(shader).text.find("counted_normal_out = f();"), std::string::npos);
}

TEST(CostReport, LinesBelongToTheirNodes) {
    const Shader shader = small_shader();
    const CountedShader counted = counted_shader(shader);
    SpirvCount count;
    count.lines.resize(3 + 6 + 2 + 1);  // no line, before, the text's six, main's first two
    uint32_t numbers = 1;
    for (ShaderCost& line : count.lines) {
        line.alu = numbers;
        count.total += line;
        numbers *= 2;
    }
    const CostReport report = cost_report(shader, counted, count);
    // Line 4 of the whole is line 1 of the text.
    ASSERT_EQ(report.nodes.size(), 2U);
    EXPECT_EQ(report.nodes[0].node, 2U);
    EXPECT_EQ(report.nodes[0].cost.alu, (1U << 7) + (1U << 8));
    EXPECT_EQ(report.nodes[1].node, 1U);
    EXPECT_EQ(report.nodes[1].cost.alu, 1U << 6);
    uint32_t sum = report.shared.alu;
    for (const NodeCost& node : report.nodes)
        sum += node.cost.alu;
    EXPECT_EQ(sum, report.total.alu);
}

TEST(CostReport, IsATable) {
    CostReport report;
    report.total = {.alu = 64, .transcendental = 1, .divisions = 2, .reads = 3};
    report.nodes = {{2, {.alu = 60, .divisions = 2, .reads = 3}}, {1, {.alu = 3}}};
    report.shared = {.alu = 1};
    report.texture_units = 2;
    EXPECT_EQ(to_text(report, small_shader().reflection),
              R"( numbers  div  reads  derivs  node
      64    2      3       0  in all, 2 of 16 texture units
      60    2      3       0  strap/tilt
       3    0      0       0  weave
       1    0      0       0  (the surface point)
)");
}

TEST(CostReport, NamesImagesBeyondTheUnits) {
    Reflection reflection;
    for (int i = 0; i < 16; ++i)
        reflection.samplers.emplace_back().written = std::to_string(i) + ".png";
    EXPECT_EQ(texture_unit_problem(reflection), "");
    SamplerInfo& last = reflection.samplers.emplace_back();
    last.written = "last.png";
    last.readers = {{"weave", "image"}};
    const std::string problem = texture_unit_problem(reflection);
    EXPECT_NE(problem.find("17 images"), std::string::npos);
    EXPECT_NE(problem.find("15.png, last.png (weave)"), std::string::npos) << problem;
}

}  // namespace
}  // namespace wrinkle::test
