// Tests of module costs: counted by hand, against the table in ir/cost.h.
#include "ir/cost.h"

#include <gtest/gtest.h>

#include "ir/value.h"

namespace wrinkle::test {
namespace {

struct CostTest : testing::Test {
    Module m;
    Value position{&m, m.input(SurfaceInput::position_)};
    Value uv{&m, m.input(SurfaceInput::uv0_)};
    uint32_t image = m.add_resource({"/x.png", "x.png", {}, {}});

    CostTest() { m.nodes.resize(3); }
    Cost of(std::initializer_list<Value> outputs, size_t node = 0) {
        m.outputs.clear();
        for (const Value& value : outputs)
            m.outputs.push_back({"value", WR_PORT_float, value.id});
        return cost_by_node(m).at(node);
    }
    Value sample(Value at) { return {&m, m.add(Op::sample_, {at.id}, image)}; }
};

TEST_F(CostTest, TheLanesOfAResultCount) {
    EXPECT_EQ(of({position + position * position.x()}), (Cost{0, 6}));
    EXPECT_EQ(of({dot(position, position)}), (Cost{0, 5}));
    EXPECT_EQ(of({op(Op::length_, position)}), (Cost{0, 6}));
    EXPECT_EQ(of({op(Op::normalize_, position)}), (Cost{0, 9}));
    EXPECT_EQ(of({op(Op::mix_, uv, position.xy(), uv.x())}), (Cost{0, 6}));
    EXPECT_EQ(of({op(Op::smoothstep_, uv.x(), uv.y(), position.x())}), (Cost{0, 7}));
    EXPECT_EQ(of({op(Op::lt_, uv.x(), uv.y())}), (Cost{0, 1}));
}

TEST_F(CostTest, TakingApartAndPuttingTogetherIsFree) {
    EXPECT_EQ(of({vec3(uv, position.z())}), Cost());
    EXPECT_EQ(of({position}), Cost());
    EXPECT_EQ(of({number(uv, 3)}), Cost());
}

TEST_F(CostTest, EachReadCountsAndWhatIsSharedCountsOnce) {
    const Value a = sample(uv), b = sample(uv + uv);
    EXPECT_EQ(of({a}), (Cost{1, 0}));
    EXPECT_EQ(of({a + b, a}), (Cost{2, 6}));
    EXPECT_EQ(of({a, a}), (Cost{1, 0}));
}

TEST_F(CostTest, WhatNobodyNeedsIsNotCounted) {
    sample(uv);
    EXPECT_EQ(of({position + position}), (Cost{0, 3}));
}

TEST_F(CostTest, EachNodeHasItsOwn) {
    m.current_node = 1;
    const Value a = sample(uv);
    m.current_node = 2;
    const Value b = a * a;
    EXPECT_EQ(of({b}, 0), Cost());
    EXPECT_EQ(of({b}, 1), (Cost{1, 0}));
    EXPECT_EQ(of({b}, 2), (Cost{0, 4}));
}

TEST_F(CostTest, ALoopsBodyCountsOnceAndNotWhatItCaptures) {
    const Value twice = uv.x() + uv.x();
    const std::array types{Type::float_};
    const Id s = m.begin_region(RegionKind::loop, "power", types)[0];
    const Value state{&m, s};
    const std::array results{op(Op::lt_, state, twice).id, (state * twice + twice).id};
    const auto last = m.apply(m.end_region(results, 100), std::array{m.number(1)});
    EXPECT_EQ(of({Value{&m, last[0]}}), (Cost{0, 1 + 3}));
}

TEST_F(CostTest, AFunctionCountsAtEachCallForTheCaller) {
    const auto function = [&](const char* name, auto body) {
        const Id x = m.begin_region(RegionKind::function, name, std::array{Type::vec2_})[0];
        return m.end_region(std::array{body(Value{&m, x}).id});
    };
    const auto call = [&](const RegionUse& use, Value at) {
        return Value{&m, m.apply(use, std::array{at.id})[0]};
    };
    m.current_node = 1;
    const RegionUse inner = function("inner", [&](Value x) { return sample(x + x).xy(); });
    const RegionUse outer =
        function("outer", [&](Value x) { return call(inner, x) * call(inner, x * x); });
    m.current_node = 2;
    const Value sum = call(outer, uv) + call(outer, position.xy());
    EXPECT_EQ(of({sum}, 1), Cost());
    EXPECT_EQ(of({sum}, 2), (Cost{4, 2 * (2 + 2 + 2 + 2) + 2}));
}

}  // namespace
}  // namespace wrinkle::test
