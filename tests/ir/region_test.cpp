// Tests of functions and loops: closed regions, interning, hoisted invariants, nesting.
#include <gtest/gtest.h>

#include "ir/inspect.h"
#include "ir/support.h"

namespace wrinkle::test {
namespace {

struct RegionTest : testing::Test {
    Module m;
    Id f = m.swizzle(m.input(SurfaceInput::uv0_), "x");
    Id g = m.swizzle(m.input(SurfaceInput::uv0_), "y");
    Surroundings around;

    RegionTest() { around.inputs[input_extra(SurfaceInput::uv0_, Variant::value)] = {0.3, 0.7}; }

    Id add(Op op, std::initializer_list<Id> args) { return m.add(op, args); }
    Id n(double value) { return m.number(value); }
    double value(Id id) {
        m.outputs = {{"value", WR_PORT_float, id}};
        EXPECT_EQ(verify(m), "");
        return interpret(m, id, around)[0];
    }
    // The function x -> x * factor + offset.
    RegionUse line(Id factor, Id offset) {
        const Id x = m.begin_region(RegionKind::function, "line", std::array{Type::float_})[0];
        return m.end_region(std::array{add(Op::add_, {add(Op::mul_, {x, factor}), offset})});
    }
    // start, start * factor, ... `count` times.
    Id power(Id start, Id factor, int count) {
        const std::array types{Type::float_, Type::float_};
        const auto s = m.begin_region(RegionKind::loop, "power", types);
        const std::array results{add(Op::lt_, {s[1], n(count)}), add(Op::mul_, {s[0], factor}),
                                 add(Op::add_, {s[1], n(1)})};
        return m.apply(m.end_region(results, 100), std::array{start, n(0)})[0];
    }
};

TEST_F(RegionTest, AFunctionGivesItsFormula) {
    const RegionUse use = line(n(3), n(1));
    EXPECT_TRUE(use.captured.empty());
    const Id y = m.apply(use, std::array{f})[0];
    EXPECT_NEAR(value(y), 1.9, 1e-15);
}

TEST_F(RegionTest, EqualFunctionsAreOneRegionAndEqualCallsOneValue) {
    const RegionUse a = line(n(3), n(1)), b = line(n(3), n(1)), c = line(n(3), n(2));
    EXPECT_EQ(a.region, b.region);
    EXPECT_NE(a.region, c.region);
    EXPECT_EQ(m.apply(a, std::array{f}), m.apply(b, std::array{f}));
    EXPECT_NE(m.apply(a, std::array{f}), m.apply(a, std::array{g}));
}

TEST_F(RegionTest, WhatAFunctionCapturesIsPassed) {
    const RegionUse a = line(f, g), b = line(g, f);
    ASSERT_EQ(a.captured.size(), 2u);
    EXPECT_EQ(m.region(a.region).params.size(), 3u);
    EXPECT_NEAR(value(m.apply(a, std::array{n(2)})[0]), 2 * 0.3 + 0.7, 1e-15);
    EXPECT_NEAR(value(m.apply(b, std::array{n(2)})[0]), 2 * 0.7 + 0.3, 1e-15);
}

// In one of the cases g is added before f.
TEST_F(RegionTest, CapturesStandInTheOrderOfTheText) {
    const Id early = add(Op::sqrt_, {g}), late = add(Op::sqrt_, {f});
    const RegionUse a = line(late, early), b = line(early, late);
    EXPECT_EQ(a.region, b.region);
    EXPECT_EQ(a.captured, (std::vector<Id>{late, early}));
    EXPECT_EQ(b.captured, (std::vector<Id>{early, late}));
}

TEST_F(RegionTest, ParametersOfTheUserAreNotCaptured) {
    const Id amount = m.parameter(m.add_parameter({0, "amount", Type::float_, {4}, false}));
    const RegionUse use = line(amount, n(0));
    EXPECT_TRUE(use.captured.empty());
    EXPECT_NEAR(value(m.apply(use, std::array{f})[0]), 1.2, 1e-15);
}

// The normal that a flat bump resolves to is that of the surface: it reads an input.
TEST_F(RegionTest, ResolvedNormalsAreCaptured) {
    const Id normal = m.add(Op::resolve_, {add(Op::gradient_zero_, {})}, 1);
    EXPECT_EQ(line(m.swizzle(normal, "z"), n(0)).captured.size(), 1u);
}

TEST_F(RegionTest, AFunctionWhoseResultIsKnownNeedsNoCall) {
    const std::array types{Type::float_, Type::vec3_};
    const auto x = m.begin_region(RegionKind::function, "known", types);
    const RegionUse use = m.end_region(std::array{n(5), x[1], add(Op::add_, {x[0], n(1)})});
    const Id v = m.input(SurfaceInput::position_);
    const auto results = m.apply(use, std::array{f, v});
    EXPECT_EQ(results[0], n(5));
    EXPECT_EQ(results[1], v);
    EXPECT_EQ(m[results[2]].op, Op::result_);
}

TEST_F(RegionTest, ACallWithConstantsIsTheirResult) {
    const RegionUse once = line(n(3), n(1));
    EXPECT_EQ(m.apply(once, std::array{n(2)})[0], n(7));
    const Id y = m.begin_region(RegionKind::function, "looped", std::array{Type::float_})[0];
    const RegionUse looped = m.end_region(std::array{power(y, n(2), 3)});
    const Id called = m.apply(looped, std::array{n(2)})[0];
    EXPECT_EQ(m[called].op, Op::result_);
    EXPECT_EQ(value(called), 16);
}

TEST_F(RegionTest, FunctionsRecordedInsideOthersAreClosedToo) {
    const Id x = m.begin_region(RegionKind::function, "outer", std::array{Type::float_})[0];
    const RegionUse inner = line(x, f);
    ASSERT_EQ(inner.captured.size(), 2u);
    const RegionUse outer = m.end_region(m.apply(inner, std::array{n(10)}));
    EXPECT_EQ(outer.captured, std::vector<Id>{f});
    EXPECT_EQ(m.region(inner.region).level, 1);
    EXPECT_NEAR(value(m.apply(outer, std::array{g})[0]), 10 * 0.7 + 0.3, 1e-14);
    EXPECT_EQ(line(f, g).region, inner.region);
}

TEST_F(RegionTest, ALoopRunsWhileItGoesOn) {
    EXPECT_NEAR(value(power(n(1), f, 4)), 0.3 * 0.3 * 0.3 * 0.3, 1e-15);
    EXPECT_NEAR(value(power(f, n(2), 0)), 0.3, 1e-15);
}

TEST_F(RegionTest, ALoopStopsAtItsMaximum) {
    const Id x = m.begin_region(RegionKind::loop, "", std::array{Type::float_})[0];
    const std::array results{add(Op::lt_, {x, n(1e9)}), add(Op::add_, {x, n(1)})};
    const RegionUse use = m.end_region(results, 7);
    EXPECT_EQ(value(m.apply(use, std::array{n(0)})[0]), 7);
}

TEST_F(RegionTest, EqualLoopsAreOneValue) {
    const Id once = power(n(1), f, 4);
    EXPECT_EQ(power(n(1), f, 4), once);
    EXPECT_NE(power(n(1), f, 5), once);
    EXPECT_NE(power(n(1), g, 4), once);
}

TEST_F(RegionTest, InvariantsStandOutside) {
    const Id x = m.begin_region(RegionKind::loop, "", std::array{Type::float_})[0];
    const Id invariant = add(Op::sin_, {add(Op::mul_, {f, g})});
    const Id inside = add(Op::mul_, {x, invariant});
    EXPECT_EQ(m[invariant].level, 0);
    EXPECT_EQ(m[inside].level, 1);
    const std::array results{add(Op::lt_, {x, n(3)}), inside};
    EXPECT_EQ(m[m.apply(m.end_region(results, 3), std::array{f})[0]].level, 0);
}

// sum over i < 3 of sum over k < i + 1 of (i * f + k)
TEST_F(RegionTest, LoopsInLoops) {
    const std::array types{Type::float_, Type::float_};
    const auto outer = m.begin_region(RegionKind::loop, "", types);
    const auto inner = m.begin_region(RegionKind::loop, "", types);
    const Id term = add(Op::add_, {add(Op::mul_, {outer[0], f}), inner[0]});
    const std::array inner_results{add(Op::le_, {inner[0], outer[0]}),
                                   add(Op::add_, {inner[0], n(1)}),
                                   add(Op::add_, {inner[1], term})};
    const Id sum = m.apply(m.end_region(inner_results, 10), std::array{n(0), outer[1]})[1];
    EXPECT_EQ(m[sum].level, 1);
    const std::array outer_results{add(Op::lt_, {outer[0], n(3)}), add(Op::add_, {outer[0], n(1)}),
                                   sum};
    const Id total = m.apply(m.end_region(outer_results, 10), std::array{n(0), n(0)})[1];
    double wanted = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k <= i; ++k)
            wanted += i * 0.3 + k;
    EXPECT_NEAR(value(total), wanted, 1e-14);
}

TEST_F(RegionTest, AFunctionWithALoopIsCalledInALoop) {
    const Id x = m.begin_region(RegionKind::function, "cube", std::array{Type::float_})[0];
    const RegionUse cube = m.end_region(std::array{power(n(1), x, 3)});
    const Id s = m.begin_region(RegionKind::loop, "", std::array{Type::float_})[0];
    const Id next = add(Op::add_, {m.apply(cube, std::array{s})[0], f});
    const std::array results{add(Op::lt_, {s, n(9)}), next};
    double wanted = 0.3;
    for (int i = 0; i < 2; ++i)
        wanted = wanted * wanted * wanted + 0.3;
    EXPECT_NEAR(value(m.apply(m.end_region(results, 2), std::array{f})[0]), wanted, 1e-15);
}

TEST_F(RegionTest, BadRegionsArePoison) {
    m.begin_region(RegionKind::loop, "", std::array{Type::float_});
    EXPECT_EQ(m.end_region(std::array{f, f}, 3).region, 0u);
    ASSERT_EQ(m.problems.size(), 1u);
    EXPECT_EQ(m.problems[0].message,
              "a loop must give a bool \"continue\" and a next state of the same types");
    EXPECT_TRUE(m.apply(RegionUse{}, std::array{f}).empty());
    m.apply(line(n(2), n(1)), std::array{m.input(SurfaceInput::position_)});
    ASSERT_EQ(m.problems.size(), 2u);
    EXPECT_EQ(m.problems[1].message, "'line' is given arguments of other types than it has");
    m.begin_region(RegionKind::function, "bad", {});
    EXPECT_EQ(m.end_region(std::array{poison}).region, 0u);
    EXPECT_EQ(m.problems.size(), 2u);
}

TEST_F(RegionTest, NestingHasALimit) {
    constexpr int depth = 300;
    Id x = f;
    for (int i = 0; i < depth; ++i)
        x = m.begin_region(RegionKind::loop, "", std::array{Type::float_})[0];
    EXPECT_EQ(x, poison);
    for (int i = 0; i < depth; ++i)
        m.end_region(std::array{m.literal(Type::bool_, 1), f}, 2);
    EXPECT_EQ(m.depth(), 0);
    EXPECT_EQ(m.problems[0].message, "loops and functions are nested more than 16 deep");
}

}  // namespace
}  // namespace wrinkle::test
