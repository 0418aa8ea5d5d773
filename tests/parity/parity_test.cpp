// Every registered node: the CPU evaluator against generated GLSL on the same points.
#include <gtest/gtest.h>

#include "gpu/context.h"
#include "parity/compare.h"
#include "parity/node_graph.h"
#include "parity/points.h"

namespace wrinkle::test {
namespace {

constexpr size_t point_count = 300;
constexpr Inputs all_inputs[] = {Inputs::defaults, Inputs::numbers, Inputs::wires, Inputs::mixed};

const PointSet& the_points() {
    static const PointSet points = random_points(point_count, 7);
    return points;
}

// One context for all tests: making one takes longer than most of them.
class Parity : public testing::Test {
protected:
    static void SetUpTestSuite() {
        Diagnostics diagnostics;
        context() = gpu::Context::offscreen(diagnostics);
        ASSERT_TRUE(context()) << to_text(diagnostics);
        ASSERT_TRUE(context()->make_current());
    }
    static void TearDownTestSuite() { context().reset(); }

    static std::optional<gpu::Context>& context() {
        static std::optional<gpu::Context> the_context;
        return the_context;
    }
};

Comparison& operator+=(Comparison& sum, const Comparison& more) {
    sum.values += more.values;
    sum.unstable += more.unstable;
    sum.different += more.different;
    return sum;
}

Comparison compare_subject(const Subject& subject) {
    const Module& module = subject.compiled.module;
    const Judge judge = make_judge(module, the_points(), test_image);
    const Values cpu = on_cpu<float>(module, the_points(), test_image);
    const Values gpu = on_gpu(module, the_points(), test_image);
    if (gpu.size() != cpu.size()) return {0, 0, 1, "no result from the GPU"};
    const Comparison result = judge.compare(cpu, gpu);
    EXPECT_EQ(result.different, 0U) << result.first << "\n" << subject.text;
    const Comparison in_double = judge.compare(cpu, judge.precise);
    EXPECT_EQ(in_double.different, 0U) << "float and double: " << in_double.first << "\n"
                                       << subject.text;
    return result;
}

TEST_F(Parity, OfEveryNode) {
    Comparison all;
    for (const NodeType& type : built_in_registry().list()) {
        SCOPED_TRACE(type.id);
        unsigned seed = 1;
        for (const Inputs inputs : all_inputs) {
            const Subject subject = compile_around(type, inputs, seed++);
            ASSERT_TRUE(subject.compiled.ok);
            all += compare_subject(subject);
        }
    }
    EXPECT_GE(all.values, built_in_registry().list().size() * point_count * std::size(all_inputs));
    EXPECT_LE(static_cast<double>(all.unstable), 0.001 * static_cast<double>(all.values));
}

}  // namespace
}  // namespace wrinkle::test
