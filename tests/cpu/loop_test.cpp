// Tests of loops and calls, with points that leave a loop at different times.
#include <gtest/gtest.h>

#include <algorithm>

#include "cpu/support.h"
#include "ir/value.h"

namespace wrinkle::test {
namespace {

constexpr size_t loop_points = 300;

Id integer(Module& m, int value) {
    return m.literal(Type::int_, value);
}

// Number of iterations of each point: 0, 1, 2, ... 12 and again.
Id rounds(Scene& s) {
    return s.m.add(Op::to_int_, {s.numbers([](size_t k) { return static_cast<double>(k % 13); })});
}

Id seed(Scene& s) {
    return s.numbers([](size_t k) { return 0.25 + 0.01 * static_cast<double>(k); });
}

// (i, x) -> (i + 1, next(x)) while i < count.
template <class Next>
Id repeat(Module& m, Id count, Id start, uint32_t limit, Next next) {
    const Type types[] = {Type::int_, Type::float_};
    const std::vector<Id> p = m.begin_region(RegionKind::loop, "", types);
    const Id results[] = {m.add(Op::lt_, {p[0], count}), m.add(Op::add_, {p[0], integer(m, 1)}),
                          next(p[0], p[1])};
    const RegionUse use = m.end_region(results, limit);
    const Id args[] = {integer(m, 0), start};
    return m.apply(use, args)[1];
}

TEST(Loops, EachPointGoesRoundAsOftenAsItShould) {
    Scene s(loop_points);
    const Id x = seed(s);
    s.output(repeat(s.m, rounds(s), x, 100, [&](Id, Id state) {
        return s.m.add(Op::add_, {state, x});
    }));
    expect_as_interpreted(s, 1e-13);
    const Results results = evaluate_all<double>(s);
    for (size_t k = 0; k < loop_points; ++k)
        EXPECT_NEAR(results.values[0][k],
                    (0.25 + 0.01 * static_cast<double>(k)) * static_cast<double>(k % 13 + 1),
                    1e-12);
}

// The state has other values after the loop than in its body.
TEST(Loops, ValuesOfTheBodyAreNotThoseAfterIt) {
    Scene s(loop_points);
    const Id two = s.m.number(2);
    const Id last = repeat(s.m, rounds(s), seed(s), 100, [&](Id, Id state) {
        return s.m.add(Op::sqrt_, {s.m.add(Op::mul_, {state, two})});
    });
    s.output(s.m.add(Op::mul_, {last, two}));
    expect_as_interpreted(s, 1e-13);
}

size_t uniform_steps(const Scene& s) {
    std::string why;
    const Program program = compile_program(s.m, why);
    return static_cast<size_t>(std::ranges::count(program.steps, true, &CpuInst::to_uniform));
}

// The sum of i * i * x.
void sum_squares(Scene& s, Id count) {
    Module& m = s.m;
    const Id x = seed(s);
    s.output(repeat(m, count, x, 20, [&](Id i, Id state) {
        const Id number = m.add(Op::to_float_, {i});
        return m.add(Op::add_, {state, m.add(Op::mul_, {m.add(Op::mul_, {number, number}), x})});
    }));
    expect_as_interpreted(s, 1e-12);
}

TEST(Loops, ACounterIsUniformIfAllPointsCountAsFar) {
    for (const size_t points : {size_t{1}, size_t{20}, size_t{31}, loop_points}) {
        Scene same(points), own(points);
        sum_squares(same, integer(same.m, 7));
        EXPECT_GE(uniform_steps(same), 5U);
        sum_squares(own, rounds(own));
        EXPECT_LE(uniform_steps(own), 1U);
    }
}

// The outer loop ends at different times; the inner counter starts again in each of its iterations.
TEST(Loops, InAVaryingLoopACounterVaries) {
    Scene s(loop_points);
    Module& m = s.m;
    s.output(repeat(m, rounds(s), seed(s), 20, [&](Id, Id outer) {
        return repeat(m, integer(m, 3), outer, 5, [&](Id i, Id state) {
            return m.add(Op::add_, {state, m.add(Op::to_float_, {i})});
        });
    }));
    expect_as_interpreted(s, 1e-12);
}

TEST(Loops, TheLimitEndsThem) {
    for (const uint32_t limit : {0u, 1u, 5u}) {
        Scene s(loop_points);
        s.output(repeat(s.m, rounds(s), seed(s), limit, [&](Id, Id state) {
            return s.m.add(Op::add_, {state, s.m.number(1)});
        }));
        expect_as_interpreted(s, 1e-13);
    }
}

TEST(Loops, MembersOfTheStateMayTradePlaces) {
    Scene s(loop_points);
    Module& m = s.m;
    const Id count = rounds(s), x = seed(s);
    const Type types[] = {Type::int_, Type::float_, Type::float_, Type::vec2_};
    const std::vector<Id> p = m.begin_region(RegionKind::loop, "", types);
    const Id results[] = {m.add(Op::lt_, {p[0], count}), m.add(Op::add_, {p[0], integer(m, 1)}),
                          p[2], m.add(Op::add_, {p[1], p[2]}), m.swizzle(p[3], "yx")};
    const RegionUse use = m.end_region(results, 20);
    const Id args[] = {integer(m, 0), x, m.number(1), m.construct(Type::vec2_, {x, m.number(7)})};
    for (const Id member : m.apply(use, args))
        s.output(member);
    expect_as_interpreted(s, 1e-12);
}

TEST(Loops, OneInsideTheOther) {
    Scene s(loop_points);
    Module& m = s.m;
    const Id count = rounds(s), x = seed(s);
    s.output(repeat(m, count, x, 50, [&](Id i, Id outer) {
        return repeat(m, i, outer, 50, [&](Id j, Id inner) {
            const Id weight = m.add(Op::to_float_, {m.add(Op::add_, {i, j})});
            return m.add(Op::add_, {inner, m.add(Op::mul_, {m.add(Op::sin_, {weight}), x})});
        });
    }));
    expect_as_interpreted(s, 1e-11);
}

TEST(Loops, TwoOfOneShapeFollowEachOther) {
    Scene s(loop_points);
    Module& m = s.m;
    const Id count = rounds(s), x = seed(s);
    const auto half = [&](Id, Id state) { return m.add(Op::mul_, {state, m.number(0.5)}); };
    const Id first = repeat(m, count, x, 9, half);
    const Id second = repeat(m, count, first, 9, half);
    s.output(m.add(Op::add_, {second, m.add(Op::mul_, {first, x})}));
    expect_as_interpreted(s, 1e-13);
}

TEST(Loops, WhatStandsBeforeALoopOutlivesIt) {
    Scene s(loop_points);
    Module& m = s.m;
    const Id x = seed(s), before = m.add(Op::cos_, {x});
    const Id looped = repeat(m, rounds(s), x, 9, [&](Id, Id state) {
        Id y = state;
        for (int i = 0; i < 20; ++i)
            y = m.add(Op::sin_, {m.add(Op::add_, {y, m.number(i)})});
        return m.add(Op::add_, {y, before});
    });
    s.output(m.add(Op::mul_, {looped, before}));
    s.output(x);
    expect_as_interpreted(s, 1e-12);
}

// f(a, b) = a * sin(b) + captured
RegionUse wave(Module& m, Id captured) {
    const Type types[] = {Type::float_, Type::float_};
    const std::vector<Id> p = m.begin_region(RegionKind::function, "wave", types);
    const Id result = m.add(Op::add_, {m.add(Op::mul_, {p[0], m.add(Op::sin_, {p[1]})}), captured});
    return m.end_region(std::span(&result, 1));
}

TEST(Calls, GiveWhatTheirBodyGives) {
    Scene s(loop_points);
    Module& m = s.m;
    const Id x = seed(s), y = s.numbers([](size_t k) { return 0.1 * static_cast<double>(k); });
    const RegionUse use = wave(m, y);
    const Id first[] = {x, y};
    const Id once = m.apply(use, first)[0];
    const Id second[] = {once, x};
    s.output(m.apply(use, second)[0]);
    s.output(once);
    expect_as_interpreted(s, 1e-12);
}

TEST(Calls, InsideLoopsAndLoopsInsideCalls) {
    Scene s(loop_points);
    Module& m = s.m;
    const Id x = seed(s), count = rounds(s);
    const Type types[] = {Type::float_, Type::int_};
    const std::vector<Id> p = m.begin_region(RegionKind::function, "sum", types);
    const RegionUse inner = wave(m, p[0]);
    const Id looped = repeat(m, p[1], p[0], 30, [&](Id i, Id state) {
        const Id args[] = {state, m.add(Op::to_float_, {i})};
        return m.apply(inner, args)[0];
    });
    const RegionUse sum = m.end_region(std::span(&looped, 1));
    s.output(repeat(m, count, x, 30, [&](Id i, Id state) {
        const Id args[] = {m.add(Op::mul_, {state, m.number(0.1)}), i};
        return m.apply(sum, args)[0];
    }));
    expect_as_interpreted(s, 1e-10);
}

TEST(Calls, WrittenOutBeyondAllMeasureAreRefused) {
    Module m;
    const Type type = Type::float_;
    RegionUse below;
    for (int depth = 0; depth < 40; ++depth) {
        const std::vector<Id> p =
            m.begin_region(RegionKind::function, "twice", std::span(&type, 1));
        Id value = m.add(Op::sin_, {p[0]});
        for (int i = 0; depth > 0 && i < 2; ++i) {
            const Id arg = m.add(Op::add_, {value, m.number(i)});
            value = m.apply(below, std::span(&arg, 1))[0];
        }
        below = m.end_region(std::span(&value, 1));
    }
    const Id x = m.swizzle(m.input(SurfaceInput::uv0_), "x");
    m.outputs = {{"height", WR_PORT_height, m.apply(below, std::span(&x, 1))[0]}};
    std::string why;
    const Program program = compile_program(m, why, 10'000);
    EXPECT_NE(why.find("10000 steps"), why.npos) << why;
    EXPECT_TRUE(program.steps.empty());
    EXPECT_TRUE(program.outputs.empty());
}

}  // namespace
}  // namespace wrinkle::test
