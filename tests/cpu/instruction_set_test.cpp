// Tests that all instruction sets agree bit by bit for every op on floats, for ordinary values and
// for special ones.
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <limits>

#include "base/srgb.h"
#include "cpu/kernels.h"
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

std::vector<InstructionSet> wide_sets() {
    std::vector<InstructionSet> sets = every_set();
    std::erase(sets, InstructionSet::baseline);
    return sets;
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
    for (const InstructionSet set : wide_sets()) {
        evaluate<T>(program, scene.points, {}, 0, wide_points, wide, set);
        for (size_t k = 0; k < baseline.values[0].size(); ++k) {
            const double x = baseline.values[0][k], y = wide.values[0][k];
            if (x != x && y != y) continue;  // NaN payloads may differ
            ASSERT_EQ(std::bit_cast<uint64_t>(x), std::bit_cast<uint64_t>(y))
                << text(a) << " at " << k << " with set " << static_cast<int>(set);
        }
    }
}

TEST(InstructionSets, GiveTheSameBits) {
    if (wide_sets().empty()) GTEST_SKIP() << "this machine has none but the baseline";
    Numbers numbers(21);
    for (const Application& a : applications()) {
        expect_same<float>(a, numbers);
        expect_same<double>(a, numbers);
    }
}

TEST(InstructionSets, EncodeSrgbWithTheSameBits) {
    Numbers numbers(23);
    std::vector<float> linear(1003), wanted;
    for (float& value : linear)
        value = static_cast<float>(numbers.number(-0.1, 1.1));
    for (const float value : linear)
        wanted.push_back(static_cast<float>(srgb_from_linear(static_cast<double>(value))));
    for (const InstructionSet set : every_set()) {
        std::vector<float> coded = linear;
        kernels_of(set).encode_srgb(coded.data(), coded.size());
        EXPECT_EQ(coded, wanted) << "set " << static_cast<int>(set);
    }
}

TEST(InstructionSets, TheEnvironmentChooses) {
    const char* before = std::getenv("WRINKLE_ISA");
    const std::string kept = before ? before : "";
    const std::pair<const char*, InstructionSet> names[] = {{"baseline", InstructionSet::baseline},
                                                            {"avx2", InstructionSet::avx2},
                                                            {"avx512", InstructionSet::avx512}};
    for (const auto& [name, set] : names) {
        setenv("WRINKLE_ISA", name, 1);
        EXPECT_EQ(default_instruction_set() == set, is_available(set)) << name;
    }
    setenv("WRINKLE_ISA", "a word", 1);
    EXPECT_EQ(default_instruction_set(), every_set().back()) << "the best there is";
    if (before)
        setenv("WRINKLE_ISA", kept.c_str(), 1);
    else
        unsetenv("WRINKLE_ISA");
    EXPECT_TRUE(is_available(default_instruction_set()));
    EXPECT_TRUE(is_available(InstructionSet::baseline));
}

}  // namespace
}  // namespace wrinkle::test
