// Tests of every op of the table on every combination of types, at 40 points with different values,
// against the reference interpreter; then the special cases documented in plugin.h.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "cpu/support.h"
#include "ir/support.h"

namespace wrinkle::test {
namespace {

constexpr size_t op_points = 40;

// With `single`, integers stay within the range that a float represents exactly.
Lanes operand_at(const Application& a, size_t which, Numbers& numbers, bool single) {
    Lanes lanes = numbers.operand(a, which);
    const bool integer = a.operands[which] == Type::int_ || a.operands[which] == Type::uint_;
    for (double& lane : lanes) {
        if (single && integer && std::fabs(lane) > 32) lane = std::floor(lane / 1024);
        if (single) lane = static_cast<double>(static_cast<float>(lane));
    }
    return lanes;
}

template <class T>
void expect_op(const Application& a, Numbers& numbers, double tolerance) {
    constexpr bool single = std::is_same_v<T, float>;
    Scene scene(op_points);
    std::vector<std::vector<Lanes>> values(a.operands.size());
    std::vector<Id> args;
    for (size_t i = 0; i < a.operands.size(); ++i) {
        for (size_t k = 0; k < op_points; ++k)
            values[i].push_back(operand_at(a, i, numbers, single));
        args.push_back(scene.operand(a.operands[i], values[i]));
    }
    const Id id = scene.m.add(a.op, args, a.extra, a.wanted);
    ASSERT_NE(id, poison) << text(a);
    const Type type = scene.m.type(id);
    scene.output(id);
    const Results results = evaluate_all<T>(scene);
    for (size_t k = 0; k < op_points; ++k) {
        std::vector<Lanes> here;
        for (const auto& each : values)
            here.push_back(each[k]);
        const Lanes wanted = apply_op(a.op, type, a.extra, a.operands, here);
        for (size_t lane = 0; lane < info(type).lanes; ++lane)
            ASSERT_NEAR(results.values[0][k * info(type).lanes + lane], wanted[lane],
                        tolerance * (1 + std::fabs(wanted[lane])))
                << text(a) << " lane " << lane << " point " << k;
    }
}

TEST(Ops, DoublesAgreeWithTheInterpreter) {
    Numbers numbers(11);
    for (const Application& a : applications())
        expect_op<double>(a, numbers, 1e-12);
}

TEST(Ops, FloatsAgreeWithTheInterpreter) {
    Numbers numbers(12);
    for (const Application& a : applications())
        expect_op<float>(a, numbers, 3e-5);
}

// One float op at one point; the arguments are inputs, so that nothing is folded.
template <class T>
double at(Op op, std::initializer_list<double> arguments) {
    Scene scene(1);
    std::vector<Id> args;
    for (const double argument : arguments)
        args.push_back(scene.scalar(std::span(&argument, 1)));
    Id value = scene.m.add(op, args);
    if (scene.m.type(value) != Type::float_) value = scene.m.add(Op::to_float_, {value});
    scene.output(value);
    return evaluate_all<T>(scene).values[0][0];
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class T>
void expect_corners() {
    const auto f = [](Op op, std::initializer_list<double> x) { return at<T>(op, x); };
    EXPECT_EQ(f(Op::mod_, {-1, 4}), 3);
    EXPECT_EQ(f(Op::mod_, {5, -3}), -1);
    EXPECT_EQ(f(Op::mod_, {-0.25, 1}), 0.75);
    EXPECT_EQ(f(Op::sign_, {0}), 0);
    EXPECT_EQ(f(Op::sign_, {-infinity}), -1);
    EXPECT_EQ(f(Op::sign_nonzero_, {0}), 1);
    EXPECT_EQ(f(Op::sign_nonzero_, {-1e-30}), -1);
    EXPECT_EQ(f(Op::clamp_, {5, 3, 1}), 1);  // min(max(5, 3), 1)
    EXPECT_EQ(f(Op::clamp_, {-5, 0, 1}), 0);
    EXPECT_EQ(f(Op::step_, {1, 1}), 1);
    EXPECT_EQ(f(Op::step_, {1, 0.5}), 0);
    EXPECT_EQ(f(Op::smoothstep_, {0, 1, -3}), 0);
    EXPECT_EQ(f(Op::smoothstep_, {0, 1, 3}), 1);
    EXPECT_EQ(f(Op::smoothstep_, {0, 2, 1}), 0.5);
    EXPECT_EQ(f(Op::floor_, {-0.5}), -1);
    EXPECT_EQ(f(Op::floor_, {-infinity}), -infinity);
    EXPECT_EQ(f(Op::floor_, {16777217.5}), std::floor(static_cast<T>(16777217.5)));
    EXPECT_EQ(f(Op::ceil_, {-0.5}), 0);
    EXPECT_EQ(f(Op::ceil_, {1e30}), static_cast<T>(1e30));
    EXPECT_EQ(f(Op::fract_, {-0.25}), 0.75);
    EXPECT_EQ(f(Op::mix_, {3, 7, 0}), 3);
    EXPECT_EQ(f(Op::mix_, {3, 7, 1}), 7);
    EXPECT_EQ(f(Op::div_, {1, 4}), 0.25);
    EXPECT_EQ(f(Op::exp_, {1000}), infinity);
    EXPECT_EQ(f(Op::to_int_, {-2.9}), -2);
    EXPECT_EQ(f(Op::to_int_, {2.9}), 2);
}

TEST(Ops, CornersInDouble) {
    expect_corners<double>();
}
TEST(Ops, CornersInFloat) {
    expect_corners<float>();
}

TEST(Ops, MinAndMaxChooseTheFirstOfUnordered) {
    EXPECT_TRUE(std::isnan(at<double>(Op::min_, {nan, 1})));
    EXPECT_EQ(at<double>(Op::min_, {1, nan}), 1);
    EXPECT_TRUE(std::isnan(at<double>(Op::max_, {nan, 1})));
    EXPECT_EQ(at<double>(Op::max_, {1, nan}), 1);
}

TEST(Ops, ComparisonsWithNanAreFalseButForNe) {
    for (const Op op : {Op::lt_, Op::le_, Op::gt_, Op::ge_, Op::eq_})
        for (const auto& [a, b] : {std::pair{nan, 1.0}, {1.0, nan}, {nan, nan}})
            EXPECT_EQ(at<float>(op, {a, b}), 0) << info(op).name;
    EXPECT_EQ(at<float>(Op::ne_, {nan, 1}), 1);
    EXPECT_EQ(at<double>(Op::ne_, {nan, nan}), 1);
}

TEST(Ops, WhatDoesNotFitAnIntIsAnInt) {
    for (const double x : {nan, infinity, -infinity, 1e30, -1e30, 2147483648.0}) {
        const double got = at<double>(Op::to_int_, {x});
        EXPECT_GE(got, -2147483648.0);
        EXPECT_LE(got, 2147483647.0);
        EXPECT_TRUE(std::isfinite(at<float>(Op::to_int_, {x})));
    }
    EXPECT_EQ(at<double>(Op::to_int_, {-2147483648.0}), -2147483648.0);
    EXPECT_EQ(at<double>(Op::to_int_, {2147483647.0}), 2147483647.0);
}

TEST(Ops, SelectTakesOneValueWhole) {
    Scene scene(2);
    const Id x = scene.numbers([](size_t k) { return k == 0 ? 1.0 : -1.0; });
    const Id bad = scene.numbers([](size_t k) { return k == 0 ? nan : infinity; });
    const Id positive = scene.m.add(Op::gt_, {x, scene.m.number(0)});
    scene.output(scene.m.add(Op::select_, {positive, x, bad}));
    scene.output(scene.m.add(Op::select_, {positive, bad, x}));
    const Results results = evaluate_all<float>(scene);
    EXPECT_EQ(results.values[0][0], 1);
    EXPECT_EQ(results.values[0][1], infinity);
    EXPECT_TRUE(std::isnan(results.values[1][0]));
    EXPECT_EQ(results.values[1][1], -1);
}

TEST(Ops, OutputsOfEveryType) {
    Scene scene(1);
    const double value = -3;
    const Id i = scene.m.add(Op::to_int_, {scene.scalar(std::span(&value, 1))});
    scene.output(i);
    scene.output(scene.m.add(Op::to_uint_, {i}));
    scene.output(scene.m.add(Op::lt_, {i, scene.m.literal(Type::int_, 0)}));
    const Results results = evaluate_all<float>(scene);
    EXPECT_EQ(results.values[0][0], -3);
    EXPECT_EQ(results.values[1][0], 4294967293.0);
    EXPECT_EQ(results.values[2][0], 1);
}

}  // namespace
}  // namespace wrinkle::test
