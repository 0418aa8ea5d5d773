// Two instruction sets, one result: every op that runs on floats, on ordinary and on strange
// numbers, bit by bit.
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <limits>

#include "cpu/support.h"
#include "ir/support.h"

namespace wrinkle::test {
namespace {

constexpr size_t wide_points = 531;

constexpr double strange[] = {
    0,     -0.0, 1,    -1,  infinity, -infinity, 1e-320,       1e-40, -1e-40, 1e300,
    -1e38, 3e9,  -3e9, 0.5, 1e6,      1e9,       2147483648.0, 1e-7,  710,    -745};

double number_at(Numbers& numbers, size_t k) {
    if (k % 3 == 0) return strange[k / 3 % std::size(strange)];
    return k % 3 == 1 ? numbers.number(-3, 3) : numbers.number(-1e5, 1e5);
}

template <class T>
void expect_same(const Application& a, Numbers& numbers) {
    Scene scene(wide_points);
    std::vector<Id> args;
    for (const Type type : a.operands) {
        std::vector<Lanes> values(wide_points);
        for (size_t k = 0; k < wide_points; ++k)
            for (double& lane : values[k])
                lane = number_at(numbers, k + args.size() * 7);
        args.push_back(scene.operand(type, values));
    }
    scene.output(scene.m.add(a.op, args, a.extra, a.wanted));
    std::string why;
    const Program program = compile_program(scene.m, why);
    Results baseline = make_results(program, wide_points),
            wide = make_results(program, wide_points);
    evaluate<T>(program, scene.points, {}, 0, wide_points, baseline, InstructionSet::baseline);
    evaluate<T>(program, scene.points, {}, 0, wide_points, wide, InstructionSet::avx2);
    for (size_t k = 0; k < baseline.values[0].size(); ++k) {
        const double x = baseline.values[0][k], y = wide.values[0][k];
        if (x != x && y != y) continue;  // which NaN is nobody's business
        ASSERT_EQ(std::bit_cast<uint64_t>(x), std::bit_cast<uint64_t>(y)) << text(a) << " at " << k;
    }
}

TEST(InstructionSets, GiveTheSameBits) {
    if (!is_available(InstructionSet::avx2)) GTEST_SKIP() << "this machine has no AVX2";
    Numbers numbers(21);
    for (const Application& a : applications()) {
        expect_same<float>(a, numbers);
        expect_same<double>(a, numbers);
    }
}

TEST(InstructionSets, TheEnvironmentChooses) {
    const char* before = std::getenv("WRINKLE_ISA");
    const std::string kept = before ? before : "";
    setenv("WRINKLE_ISA", "baseline", 1);
    EXPECT_EQ(default_instruction_set(), InstructionSet::baseline);
    setenv("WRINKLE_ISA", "avx2", 1);
    EXPECT_EQ(default_instruction_set() == InstructionSet::avx2,
              is_available(InstructionSet::avx2));
    if (before)
        setenv("WRINKLE_ISA", kept.c_str(), 1);
    else
        unsetenv("WRINKLE_ISA");
    EXPECT_TRUE(is_available(default_instruction_set()));
    EXPECT_TRUE(is_available(InstructionSet::baseline));
}

}  // namespace
}  // namespace wrinkle::test
