// Tests of compact(): joined calls and loops, packed components. Values never change.
#include <gtest/gtest.h>

#include "ir/compact.h"
#include "ir/derive.h"
#include "ir/inspect.h"
#include "ir/rewrite.h"
#include "ir/support.h"

namespace wrinkle::test {
namespace {

struct CompactTest : testing::Test {
    Module m;
    Id uv = m.input(SurfaceInput::uv0_);
    Id x = m.swizzle(uv, "x"), y = m.swizzle(uv, "y");
    Surroundings around;

    CompactTest() { around.inputs[input_extra(SurfaceInput::uv0_, Variant::value)] = {0.3, 0.7}; }

    Id add(Op op, std::initializer_list<Id> args) { return m.add(op, args); }
    Id n(double value) { return m.number(value); }
    // Returns the module with these outputs, compact; compares the values.
    Module compacted(std::initializer_list<Id> outputs) {
        for (const Id output : outputs)
            m.outputs.push_back({"o" + std::to_string(m.outputs.size()), WR_PORT_float, output});
        std::vector<std::vector<double>> before, after;
        for (const ModuleOutput& output : m.outputs)
            before.push_back(components(m, output.value));
        Module result = compact(m);
        EXPECT_EQ(verify(result), "");
        for (const ModuleOutput& output : result.outputs)
            after.push_back(components(result, output.value));
        EXPECT_EQ(before, after);
        return result;
    }
    std::vector<double> components(const Module& module, Id id) const {
        const auto lanes = interpret(module, id, around);
        return {lanes.begin(), lanes.begin() + info(module.type(id)).lanes};
    }
    static size_t count(const Module& module, Op op) {
        const std::vector<bool> needed = reachable(module);
        size_t found = 0;
        for (Id id = 1; id < module.size(); ++id)
            found += needed[id] && module[id].op == op;
        return found;
    }
    // A function of one float; body(x) returns its result.
    template <class Body>
    RegionUse function(const char* name, Body body) {
        const Id p = m.begin_region(RegionKind::function, name, std::array{Type::float_})[0];
        return m.end_region(std::array{body(p)});
    }
    Id call(const RegionUse& use, Id argument) { return m.apply(use, std::array{argument})[0]; }
};

TEST_F(CompactTest, AValueAndItsSlopeComeFromOneCall) {
    const auto wave = function("wave", [&](Id p) { return add(Op::sin_, {add(Op::exp_, {p})}); });
    const auto slope = function("wave_slope", [&](Id p) {
        return add(Op::mul_, {add(Op::cos_, {add(Op::exp_, {p})}), add(Op::exp_, {p})});
    });
    const Module result = compacted({call(wave, x), call(slope, x), call(wave, y)});
    EXPECT_EQ(count(result, Op::call_), 2u);
    EXPECT_EQ(count(result, Op::exp_), 1u);
    EXPECT_EQ(print(result).find("wave_slope"), std::string::npos);
}

TEST_F(CompactTest, FunctionsWithoutSharedWorkStayApart) {
    const auto sine = function("sine", [&](Id p) { return add(Op::sin_, {p}); });
    const auto cosine = function("cosine", [&](Id p) { return add(Op::cos_, {p}); });
    EXPECT_EQ(count(compacted({call(sine, x), call(cosine, x)}), Op::call_), 2u);
}

TEST_F(CompactTest, FunctionsOfJoinedFunctionsAreJoined) {
    const auto inner = function("f", [&](Id p) { return add(Op::sin_, {add(Op::exp_, {p})}); });
    const auto inner_slope =
        function("f_slope", [&](Id p) { return add(Op::cos_, {add(Op::exp_, {p})}); });
    const auto outer = function("g", [&](Id p) {
        return add(Op::mul_, {call(inner, p), add(Op::sqrt_, {p})});
    });
    const auto outer_slope = function("g_slope", [&](Id p) {
        return add(Op::mul_, {call(inner_slope, p), add(Op::sqrt_, {p})});
    });
    const Module result = compacted({call(outer, x), call(outer_slope, x)});
    EXPECT_EQ(count(result, Op::call_), 2u);
    EXPECT_EQ(count(result, Op::sqrt_), 1u);
    EXPECT_EQ(count(result, Op::exp_), 1u);
}

TEST_F(CompactTest, ResultsThatNoCallReadsAreDropped) {
    const Id p = m.begin_region(RegionKind::function, "two", std::array{Type::float_})[0];
    const auto use = m.end_region(std::array{add(Op::sin_, {p}), add(Op::cos_, {p})});
    const Module result = compacted({m.apply(use, std::array{x})[1]});
    EXPECT_EQ(count(result, Op::sin_), 0u);
    EXPECT_EQ(count(result, Op::cos_), 1u);
}

// sum of sin(k p) for k below 5, and its derivatives along two directions.
TEST_F(CompactTest, AllDirectionsOfALoopAreOneLoop) {
    const auto s =
        m.begin_region(RegionKind::loop, "sum(k, sum)", std::array{Type::float_, Type::float_});
    const Id term = add(Op::sin_, {add(Op::add_, {add(Op::mul_, {x, s[0]}), y})});
    const auto use =
        m.end_region(std::array{add(Op::lt_, {s[0], n(5)}), add(Op::add_, {s[0], n(1)}),
                                add(Op::add_, {s[1], term})},
                     8);
    const Id sum = m.apply(use, std::array{n(0), n(0)})[1];
    ForwardDiff along_x = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0));
    ForwardDiff along_y = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 1));
    const Id slope = m.construct(Type::vec2_, {along_x.jvp(sum), along_y.jvp(sum)});
    const Module result = compacted({sum, slope});
    EXPECT_EQ(count(result, Op::loop_), 1u);
    EXPECT_NE(print(result).find("(float, float, vec2)"), std::string::npos) << print(result);
}

TEST_F(CompactTest, MembersThatNothingReadsAreDropped) {
    const auto s =
        m.begin_region(RegionKind::loop, "", std::array{Type::float_, Type::float_, Type::float_});
    const auto use =
        m.end_region(std::array{add(Op::lt_, {s[0], n(5)}), add(Op::add_, {s[0], n(1)}),
                                add(Op::sin_, {s[1]}), add(Op::cos_, {s[2]})},
                     8);
    const Module result = compacted({m.apply(use, std::array{n(0), x, y})[2]});
    EXPECT_EQ(count(result, Op::sin_), 0u);
}

// The inner value of the second loop is the result of the first.
// The body of the second loop reads the result of the first one; their parameters are on one level.
// Only those of the second loop move when its unread member is dropped.
TEST_F(CompactTest, ALoopThatABodyReadsStaysAsItIs) {
    const std::array three{Type::float_, Type::float_, Type::float_};
    const auto a = m.begin_region(RegionKind::loop, "first(k, step, sum)", three);
    const auto first =
        m.end_region(std::array{add(Op::lt_, {a[0], n(5)}), add(Op::add_, {a[0], n(1)}),
                                add(Op::add_, {a[1], x}), add(Op::add_, {a[2], a[1]})},
                     8);
    const Id inner = m.apply(first, std::array{n(0), n(1), n(0)})[2];
    const auto b = m.begin_region(RegionKind::loop, "second(k, unread, sum)", three);
    const Id term = add(Op::sin_, {add(Op::mul_, {inner, b[0]})});
    const auto second =
        m.end_region(std::array{add(Op::lt_, {b[0], n(3)}), add(Op::add_, {b[0], n(1)}),
                                add(Op::add_, {b[1], n(1)}), add(Op::add_, {b[2], term})},
                     8);
    const Module result = compacted({m.apply(second, std::array{n(0), n(0), n(0)})[2]});
    EXPECT_EQ(count(result, Op::loop_), 2u);
}

TEST_F(CompactTest, ALoopIsNotJoinedWithOneThatItDependsOn) {
    const auto s = m.begin_region(RegionKind::loop, "", std::array{Type::float_, Type::float_});
    const auto use =
        m.end_region(std::array{add(Op::lt_, {s[0], n(5)}), add(Op::add_, {s[0], n(1)}),
                                add(Op::add_, {s[1], s[0]})},
                     8);
    const Id first = m.apply(use, std::array{n(0), x})[1];
    EXPECT_EQ(count(compacted({m.apply(use, std::array{n(0), first})[1]}), Op::loop_), 2u);
}

TEST_F(CompactTest, ComponentsOfOneFormBecomeOneVector) {
    const Id a = add(Op::mul_, {add(Op::sin_, {x}), n(3)});
    const Id b = add(Op::mul_, {add(Op::sin_, {y}), n(3)});
    const Module result = compacted({m.construct(Type::vec2_, {a, b})});
    EXPECT_EQ(count(result, Op::sin_), 1u);
    EXPECT_EQ(count(result, Op::mul_), 1u);
    EXPECT_EQ(count(result, Op::construct_), 0u);
}

TEST_F(CompactTest, ChoicesByOtherConditionsStayApart) {
    const Id a = add(Op::select_, {add(Op::lt_, {x, n(0.5)}), x, n(1)});
    const Id b = add(Op::select_, {add(Op::lt_, {y, n(0.5)}), y, n(1)});
    EXPECT_EQ(count(compacted({m.construct(Type::vec2_, {a, b})}), Op::select_), 2u);
}

TEST_F(CompactTest, AScalarThatOthersReadTooStaysOne) {
    const Id a = add(Op::sin_, {x}), b = add(Op::sin_, {y});
    EXPECT_EQ(
        count(compacted({m.construct(Type::vec2_, {a, b}), add(Op::add_, {a, n(1)})}), Op::sin_),
        2u);
}

// The sum of sin(k + x) for k below a number, by a function; `offset` makes calls differ.
struct NestTest : CompactTest {
    RegionUse sum = function("sum", [&](Id p) {
        const auto s = m.begin_region(RegionKind::loop, "", std::array{Type::float_, Type::float_});
        const Id term = add(Op::sin_, {add(Op::add_, {s[0], p})});
        const auto use =
            m.end_region(std::array{add(Op::lt_, {s[0], n(5)}), add(Op::add_, {s[0], n(1)}),
                                    add(Op::add_, {s[1], term})},
                         8);
        return m.apply(use, std::array{n(0), n(0)})[1];
    });
    // Returns the number of loops in the module of a sum of calls.
    size_t loops_of_calls(int calls) {
        Id total = x;
        for (int k = 0; k < calls; ++k)
            total = add(Op::add_, {total, call(sum, add(Op::add_, {y, n(k)}))});
        m.outputs = {{"o", WR_PORT_float, total}};
        const std::vector<double> before = components(m, total);
        const Module result = nest_loops(m);
        EXPECT_EQ(verify(result), "");
        EXPECT_EQ(components(result, result.outputs[0].value), before);
        return count(result, Op::loop_);
    }
};

TEST_F(NestTest, EightLoopsInARowStay) {
    EXPECT_EQ(loops_of_calls(8), 1u);
}

TEST_F(NestTest, NineBecomeLoopsOfLoops) {
    EXPECT_EQ(loops_of_calls(9), 2u);
}

}  // namespace
}  // namespace wrinkle::test
