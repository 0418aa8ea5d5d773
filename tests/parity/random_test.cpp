// Tests that random numbers have equal bits on the CPU and the GPU.
#include <gtest/gtest.h>

#include <set>

#include "certify/points.h"
#include "certify/subject.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/node_graph.h"

namespace wrinkle::test {
namespace {

using Random = WithGpu;

// Cells of 64 to a uv unit: a product with a power of two is exact.
const std::string cells_of_points =
    R"("cell": {"type": "vec2_scale", "in": {"vector": {"from": "surface.uv0"}, "factor": 64}})";

std::string random_graph(const std::string& type, const std::string& in,
                         const std::vector<std::string>& outputs) {
    std::string named;
    for (const std::string& output : outputs)
        named += (named.empty() ? "\"" : ", \"") + output + R"(": {"from": "n.)" + output + "\"}";
    return R"({"wrinkle": 1, "nodes": {)" + cells_of_points + R"(, "n": {"type": ")" + type +
           R"(", "in": {)" + in + R"(}}}, "outputs": {)" + named + "}}";
}

// Returns the number of different values of the first output.
size_t expect_equal_bits(const std::string& graph) {
    Diagnostics diagnostics;
    const certify::CertifyContext context = bench(true);
    const Project project = certify::project_of(graph, context, diagnostics);
    const Compiled compiled = certify::compile(project, context, {}, diagnostics);
    EXPECT_EQ(to_text(diagnostics), "");
    if (!compiled.ok) return 0;
    const PointSet points = certify::random_points(20000, 5, {-8, 8});
    const Values cpu = on_cpu<float>(compiled.module, points, test_image);
    const Values gpu = on_gpu(compiled.module, points, test_image);
    EXPECT_EQ(cpu.size(), gpu.size());
    for (size_t k = 0; k < cpu.size() && k < gpu.size(); ++k)
        EXPECT_EQ(cpu[k], gpu[k]) << compiled.module.outputs[k].name;
    return std::set<double>(cpu[0].begin(), cpu[0].end()).size();
}

TEST_F(Random, HasEqualBitsOnTheCpuAndTheGpu) {
    const std::string cell = R"("cell": {"from": "cell.vector"}, "seed": 3)";
    EXPECT_GT(expect_equal_bits(random_graph("random", cell, {"value", "vector", "color"})),
              15000U);
    EXPECT_GT(expect_equal_bits(random_graph("random", cell + R"(, "id": 7)", {"value"})), 15000U);
}

// A power of two of cells: rounding does not move a point to another one.
TEST_F(Random, OfCellsHasEqualBits) {
    for (const char* type : {"bricks", "checker", "domes", "truchet"})
        EXPECT_GT(
            expect_equal_bits(random_graph(type, R"("scale": 8, "seed": 2)", {"random", "cell"})),
            5000U)
            << type;
}

}  // namespace
}  // namespace wrinkle::test
