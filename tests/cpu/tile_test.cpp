// Tests that tile borders do not affect results, that long chains need little memory, and that
// missing values are named.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <thread>

#include "cpu/support.h"
#include "ir/value.h"
#include "support/small_stack.h"

namespace wrinkle::test {
namespace {

// A program with every construct that varies per point: branches, a loop, transcendentals.
void write_material(Scene& s) {
    Module& m = s.m;
    const Value x{&m, s.numbers([](size_t k) { return std::sin(static_cast<double>(k)); })};
    const Value y{&m, s.numbers([](size_t k) { return 0.01 * static_cast<double>(k); })};
    const Type types[] = {Type::float_, Type::float_};
    const std::vector<Id> p = m.begin_region(RegionKind::loop, "", types);
    const Id results[] = {m.add(Op::lt_, {p[0], x.id}), m.add(Op::add_, {p[0], m.number(0.125)}),
                          m.add(Op::sin_, {m.add(Op::add_, {p[1], p[0]})})};
    const RegionUse use = m.end_region(results, 30);
    const Id args[] = {m.number(-1), y.id};
    const Value looped{&m, m.apply(use, args)[1]};
    const Value exponential = op(Op::exp_, op(Op::mul_, x, y));
    s.output(m.construct(Type::vec3_, {looped.id, exponential.id, (x / y).id}));
    s.output(normalize(vec2(looped, select(greater(x, 0.3), x, y))).id);
}

template <class T>
void expect_same_bits(const Results& a, const Results& b) {
    ASSERT_EQ(a.values.size(), b.values.size());
    for (size_t i = 0; i < a.values.size(); ++i) {
        ASSERT_EQ(a.values[i].size(), b.values[i].size());
        for (size_t k = 0; k < a.values[i].size(); ++k)
            ASSERT_EQ(std::bit_cast<uint64_t>(a.values[i][k]),
                      std::bit_cast<uint64_t>(b.values[i][k]))
                << "output " << i << " at " << k;
    }
}

template <class T>
void expect_split_invariance(size_t count) {
    Scene s(count);
    write_material(s);
    const Results whole = evaluate_all<T>(s);
    std::string why;
    const Program program = compile_program(s.m, why);
    for (const size_t piece : {size_t{1}, size_t{7}, size_t{255}, size_t{256}, size_t{513}}) {
        Results split = make_results(program, count);
        for (size_t first = 0; first < count; first += piece)
            evaluate<T>(program, s.points, {}, first, std::min(piece, count - first), split);
        expect_same_bits<T>(whole, split);
    }
}

TEST(Tiles, SplittingChangesNothing) {
    for (const size_t count : {1, 255, 512, 513, 1200}) {
        expect_split_invariance<float>(count);
        expect_split_invariance<double>(count);
    }
}

TEST(Tiles, NoPointsAreFine) {
    Scene s(0);
    write_material(s);
    EXPECT_TRUE(evaluate_all<float>(s).values[0].empty());
}

TEST(Tiles, ThreadsWriteTheirOwnPoints) {
    Scene s(1000);
    write_material(s);
    const Results whole = evaluate_all<float>(s);
    std::string why;
    const Program program = compile_program(s.m, why);
    Results together = make_results(program, 1000);
    std::vector<std::thread> threads;
    for (size_t first = 0; first < 1000; first += 250)
        threads.emplace_back(
            [&, first] { evaluate<float>(program, s.points, {}, first, 250, together); });
    for (std::thread& thread : threads)
        thread.join();
    expect_same_bits<float>(whole, together);
}

TEST(Tiles, FloatIsRoundedDouble) {
    Scene s(500);
    write_material(s);
    const Results single = evaluate_all<float>(s), full = evaluate_all<double>(s);
    size_t apart = 0;
    for (size_t i = 0; i < single.values.size(); ++i)
        for (size_t k = 0; k < single.values[i].size(); ++k) {
            const double wanted = full.values[i][k];
            if (!std::isfinite(wanted)) continue;
            apart += std::fabs(single.values[i][k] - wanted) > 1e-4 * (1 + std::fabs(wanted));
            EXPECT_EQ(single.values[i][k],
                      static_cast<double>(static_cast<float>(single.values[i][k])));
        }
    EXPECT_LT(apart, 15u);  // a loop may end one iteration earlier
}

TEST(Inputs, EachIsNamedOnce) {
    Module m;
    const Id uv = m.input(SurfaceInput::uv1_),
             change = m.input(SurfaceInput::position_, Variant::dy);
    m.input(SurfaceInput::tangent_);  // no output uses it
    const Id sum = m.add(Op::add_, {m.swizzle(uv, "x"), m.swizzle(change, "z")});
    m.outputs = {{"a", WR_PORT_float, m.add(Op::mul_, {sum, m.swizzle(uv, "x")})},
                 {"b", WR_PORT_vec2, uv}};
    std::string why;
    const auto needs = needed_inputs(compile_program(m, why));
    ASSERT_EQ(needs.size(), 2u);
    EXPECT_EQ(needs[0].input, SurfaceInput::position_);
    EXPECT_EQ(needs[0].variant, Variant::dy);
    EXPECT_EQ(needs[1].input, SurfaceInput::uv1_);
    EXPECT_EQ(needs[1].variant, Variant::value);
}

TEST(Parameters, HaveTheValueOfTheModule) {
    Scene s(1);
    const Id p = s.m.parameter(s.m.add_parameter({0, "tint", Type::vec3_, {1, 2, 3}, false}));
    s.output(s.m.add(Op::mul_, {p, s.m.number(2)}));
    EXPECT_EQ(evaluate_all<float>(s).values[0], (std::vector<double>{2, 4, 6}));
}

constexpr int chain_length = 100'000;

// Every link has its own parameter, as in a graph with 100,000 sliders.
void evaluate_chain() {
    Scene s(3);
    Module& m = s.m;
    const Id start = s.numbers([](size_t k) { return static_cast<double>(k); });
    Id x = start;
    for (int i = 0; i < chain_length; ++i)
        x = m.add(Op::add_, {m.add(Op::mul_, {x, m.number(0.25 + 1e-7 * i)}), start});
    s.output(x);
    std::string why;
    const Program program = compile_program(m, why);
    EXPECT_LT(program.float_registers - program.uniform_floats, 16u);
    EXPECT_LT(program.steps.size(), 3u * chain_length + 10);
    const Results results = evaluate_all<double>(s);
    for (size_t k = 0; k < 3; ++k) {
        double wanted = static_cast<double>(k);
        for (int i = 0; i < chain_length; ++i)
            wanted = wanted * (0.25 + 1e-7 * i) + static_cast<double>(k);
        EXPECT_EQ(results.values[0][k], wanted);
    }
}

TEST(Chains, AHundredThousandLinksNeedFewRegistersAndLittleStack) {
    on_small_stack(evaluate_chain);
}

// Many simultaneously live values, in the order of their last uses.
TEST(Chains, ManyLiveValuesKeepApart) {
    Scene s(2);
    Module& m = s.m;
    const Id x = s.numbers([](size_t k) { return 1.0 + static_cast<double>(k); });
    std::vector<Id> values;
    for (int i = 0; i < 300; ++i)
        values.push_back(m.add(Op::mul_, {x, m.number(i + 2)}));
    Id sum = x;
    for (const Id value : values)
        sum = m.add(Op::add_, {sum, value});
    s.output(sum);
    const Results results = evaluate_all<float>(s);
    EXPECT_EQ(results.values[0][0], 1 + 299 * 150 + 600);
    EXPECT_EQ(results.values[0][1], 2 * (1 + 299 * 150 + 600));
}

}  // namespace
}  // namespace wrinkle::test
