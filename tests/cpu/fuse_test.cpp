// Tests that fused steps give the same bits as separate steps: in the second version of each
// expression every intermediate value is an output, which prevents fusion.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>

#include "cpu/support.h"

namespace wrinkle::test {
namespace {

constexpr size_t fuse_points = 300;

using Make = std::function<Id(Scene&, std::vector<Id>& between)>;

struct Made {
    Program program;
    std::vector<double> values;  // last output
};

template <class T>
Made make(const Make& expression, bool apart) {
    Scene s(fuse_points);
    std::vector<Id> between;
    const Id value = expression(s, between);
    if (apart)
        for (const Id id : between)
            s.output(id);
    s.output(value);
    std::string why;
    Made made{compile_program(s.m, why), {}};
    Results results = make_results(made.program, fuse_points);
    Image image = make_image(4, 4, 3, PixelType::u8);
    for (size_t k = 0; k < image.data.size(); ++k)
        image.data[k] = static_cast<float>(k * 5 % 256) / 255;
    const Texture texture(build_mips(std::move(image)), {});
    evaluate<T>(made.program, s.points, std::span(&texture, 1), 0, fuse_points, results);
    made.values = std::move(results.values.back());
    return made;
}

void expect_fused(const Make& expression, size_t steps) {
    const Made fused = make<float>(expression, false), apart = make<float>(expression, true);
    EXPECT_EQ(fused.program.steps.size(), steps);
    EXPECT_GT(apart.program.steps.size(), steps);
    const Made doubles = make<double>(expression, false), parts = make<double>(expression, true);
    for (size_t k = 0; k < fuse_points; ++k) {
        ASSERT_EQ(std::bit_cast<uint64_t>(fused.values[k]),
                  std::bit_cast<uint64_t>(apart.values[k]))
            << "point " << k;
        ASSERT_EQ(std::bit_cast<uint64_t>(doubles.values[k]),
                  std::bit_cast<uint64_t>(parts.values[k]))
            << "point " << k;
    }
}

// Numbers of both signs with inexact products and sums, including zeros of both signs.
Id operand(Scene& s, uint64_t seed) {
    return s.numbers([seed](size_t k) {
        if (k % 11 == seed % 11) return k % 2 ? -0.0 : 0.0;
        const double at = static_cast<double>((k * 2654435761U + seed * 40503U) % 10007);
        return at / 1234.567 - 4.05;
    });
}

TEST(Fused, EveryPairInEitherOrder) {
    for (const Op first : {Op::abs_, Op::add_, Op::sub_, Op::mul_, Op::min_, Op::max_})
        for (const Op second : {Op::add_, Op::sub_, Op::mul_, Op::min_, Op::max_})
            for (const bool swapped : {false, true})
                expect_fused(
                    [&](Scene& s, std::vector<Id>& between) {
                        const Id a = operand(s, 1), b = operand(s, 2), c = operand(s, 3);
                        const Id inner =
                            first == Op::abs_ ? s.m.add(first, {a}) : s.m.add(first, {a, b});
                        between = {inner};
                        return swapped ? s.m.add(second, {c, inner}) : s.m.add(second, {inner, c});
                    },
                    1);
}

TEST(Fused, SumsOfProducts) {
    const auto products = [](int count, bool last_first) {
        return [=](Scene& s, std::vector<Id>& between) {
            Id sum = poison;
            for (int i = 0; i < count; ++i) {
                const auto seed = static_cast<uint64_t>(2 * i);
                const Id product = s.m.add(Op::mul_, {operand(s, seed), operand(s, seed + 1)});
                between.push_back(product);
                if (i > 1) between.push_back(sum);
                sum = i == 0                         ? product
                      : last_first && i + 1 == count ? s.m.add(Op::add_, {product, sum})
                                                     : s.m.add(Op::add_, {sum, product});
            }
            return sum;
        };
    };
    expect_fused(products(2, false), 1);
    expect_fused(products(3, false), 1);
    expect_fused(products(3, true), 1);
}

TEST(Fused, ADecodedNormalsDepth) {
    expect_fused(
        [](Scene& s, std::vector<Id>& between) {
            Module& m = s.m;
            const Id v = s.numbers([](size_t k) { return 0.017 * static_cast<double>(k); });
            const uint32_t picture = m.add_resource({"picture", "", {}, {}});
            const Id texel = m.swizzle(
                m.add(Op::sample_lod_, {m.construct(Type::vec2_, {v, v}), m.number(0)}, picture),
                "xyz");
            between.push_back(texel);
            const Id t = m.add(Op::sub_, {texel, m.number(0.5)});
            const Id x = m.add(Op::abs_, {m.swizzle(t, "x")}),
                     y = m.add(Op::abs_, {m.swizzle(t, "y")});
            const Id greatest = m.add(Op::max_, {x, y});
            const Id least = m.add(Op::mul_, {greatest, m.number(0.0078125)});
            const Id deep = m.add(Op::max_, {m.add(Op::abs_, {m.swizzle(t, "z")}), least});
            for (const Id id : {x, y, greatest, least, deep})
                between.push_back(id);
            return m.add(Op::max_, {deep, m.number(5e-7)});
        },
        10);  // and a copy of the constant level of detail
}

// As in hashes. A shift uses the lowest five bits of its second operand.
TEST(Fused, EveryPairOfIntegersInEitherOrder) {
    const auto ops = {Op::add_, Op::mul_, Op::bit_and_, Op::bit_xor_, Op::shift_right_};
    const auto word = [](Scene& s, uint64_t seed) {
        std::vector<Lanes> values(fuse_points);
        for (size_t k = 0; k < fuse_points; ++k)
            values[k][0] = static_cast<double>((k * 2654435761U + seed * 40503U) % 16777216);
        return s.operand(Type::uint_, values);
    };
    for (const Op first : ops)
        for (const Op second : ops)
            for (const bool swapped : {false, true})
                expect_fused(
                    [&](Scene& s, std::vector<Id>& between) {
                        const Id c = word(s, 3);
                        const Id inner = s.m.add(first, {word(s, 1), word(s, 2)});
                        between = {inner};
                        return swapped ? s.m.add(second, {c, inner}) : s.m.add(second, {inner, c});
                    },
                    4);  // three convert the operands from float
}

TEST(Fused, AConversionWithWhatReadsIt) {
    std::vector<Lanes> values(fuse_points);
    for (size_t k = 0; k < fuse_points; ++k)
        values[k][0] = static_cast<double>((k * 2654435761U) % 16777216);
    for (const Op second : {Op::add_, Op::sub_, Op::mul_, Op::min_, Op::max_})
        for (const bool swapped : {false, true})
            expect_fused(
                [&](Scene& s, std::vector<Id>& between) {
                    const Id bits = s.m.add(Op::bit_xor_, {s.operand(Type::uint_, values),
                                                           s.m.literal(Type::uint_, 12345)});
                    const Id number = s.m.add(Op::to_float_, {bits}), c = operand(s, 3);
                    between = {number};
                    return swapped ? s.m.add(second, {c, number}) : s.m.add(second, {number, c});
                },
                3);
}

TEST(Steps, ASineAndACosineAreOne) {
    Scene s(fuse_points);
    const Id x = operand(s, 1);
    s.output(s.m.add(Op::sin_, {x}));
    s.output(s.m.add(Op::cos_, {x}));
    std::string why;
    EXPECT_EQ(compile_program(s.m, why).steps.size(), 1U);
    expect_as_interpreted(s, 1e-15);
}

Id pcg_hash(Module& m, Id x) {
    const auto word = [&](double value) { return m.literal(Type::uint_, value); };
    const Id sum = m.add(Op::add_, {m.add(Op::mul_, {x, word(747796405)}), word(2891336453)});
    const Id by = m.add(Op::add_, {m.add(Op::shift_right_, {sum, word(28)}), word(4)});
    const Id mixed = m.add(Op::bit_xor_, {m.add(Op::shift_right_, {sum, by}), sum});
    const Id product = m.add(Op::mul_, {mixed, word(277803737)});
    return m.add(Op::bit_xor_, {m.add(Op::shift_right_, {product, word(22)}), product});
}

size_t hash_steps(const Module& m) {
    std::string why;
    const auto steps = compile_program(m, why).steps;
    return static_cast<size_t>(std::ranges::count(steps, CpuInst::Kind::hash, &CpuInst::kind));
}

TEST(Fused, AHashOfAHash) {
    Scene s(fuse_points);
    const Id x = s.m.add(Op::to_uint_, {s.m.add(Op::to_int_, {operand(s, 1)})});
    s.output(pcg_hash(s.m, pcg_hash(s.m, x)));
    EXPECT_EQ(hash_steps(s.m), 2U);
    expect_as_interpreted(s, 0);
}

TEST(Fused, NoHashOfOtherConstants) {
    Scene s(fuse_points);
    const auto word = [&](double value) { return s.m.literal(Type::uint_, value); };
    const Id x = s.m.add(Op::to_uint_, {s.m.add(Op::to_int_, {operand(s, 1)})});
    const Id p = s.m.add(Op::mul_, {x, word(277803737)});
    s.output(s.m.add(Op::bit_xor_, {s.m.add(Op::shift_right_, {p, word(22)}), p}));
    EXPECT_EQ(hash_steps(s.m), 0U);
    expect_as_interpreted(s, 0);
}

TEST(Steps, EqualOnesOfTwoCallsAreOne) {
    Scene s(fuse_points);
    Module& m = s.m;
    const Type types[] = {Type::float_, Type::float_};
    const std::vector<Id> p = m.begin_region(RegionKind::function, "f", types);
    const Id results[] = {m.add(Op::div_, {m.add(Op::sqrt_, {p[0]}), p[1]})};
    const RegionUse use = m.end_region(results);
    const Id x = operand(s, 1);
    const Id first[] = {x, operand(s, 2)}, second[] = {x, operand(s, 3)};
    s.output(m.apply(use, first)[0]);
    s.output(m.apply(use, second)[0]);
    std::string why;
    EXPECT_EQ(compile_program(m, why).steps.size(), 3U);
}

TEST(Unused, ComponentsTakeNoStep) {
    Scene s(fuse_points);
    const Id vector = s.m.construct(Type::vec3_, {operand(s, 1), operand(s, 2), operand(s, 3)});
    s.output(s.m.swizzle(s.m.add(Op::mul_, {vector, vector}), "y"));
    std::string why;
    EXPECT_EQ(compile_program(s.m, why).steps.size(), 1U);
}

// A value computed before a loop and used inside it is not recomputed in every iteration.
TEST(Fused, NothingIntoALoop) {
    Scene s(fuse_points);
    Module& m = s.m;
    const Id b = operand(s, 2), product = m.add(Op::mul_, {operand(s, 1), b});
    const Type types[] = {Type::float_};
    const std::vector<Id> p = m.begin_region(RegionKind::loop, "", types);
    const Id results[] = {m.add(Op::lt_, {p[0], m.number(100)}), m.add(Op::add_, {product, p[0]})};
    const RegionUse use = m.end_region(results, 5);
    const Id start[] = {b};
    s.output(m.apply(use, start)[0]);
    std::string why;
    const Program program = compile_program(s.m, why);
    for (const CpuInst& step : program.steps)
        EXPECT_NE(step.kind, CpuInst::Kind::pair);
    expect_as_interpreted(s, 1e-12);
}

}  // namespace
}  // namespace wrinkle::test
