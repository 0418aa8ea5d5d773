// Tests of every op of the table on every combination of types: constants fold to the interpreter's
// result, and derivatives agree with central differences.
#include <gtest/gtest.h>

#include <cmath>

#include "ir/derive.h"
#include "ir/support.h"

namespace wrinkle::test {
namespace {

constexpr int trials = 4;

TEST(OpTable, EachOpHasApplicationsOrIsTestedElsewhere) {
    std::map<Op, int> count;
    for (const Application& a : applications())
        ++count[a.op];
#define X(name, number, arity, rule, glsl, precedence, flags) \
    EXPECT_TRUE(tested_elsewhere(Op::name##_) || count[Op::name##_] > 0) << #name;
    WR_OPS(X)
#undef X
}

// Operands of any type: their number is checked first.
TEST(OpTable, AnOperandTooManyIsRefusedByItsNumber) {
    Module m;
    const Id leaf = new_leaf(m, Type::float_);
    const auto expect = [&](Op op, const std::string& name, int arity) {
        m.problems.clear();
        const std::vector<Id> args(static_cast<size_t>(arity) + 1, leaf);
        EXPECT_EQ(m.add(op, args), poison) << name;
        ASSERT_EQ(m.problems.size(), 1u) << name;
        EXPECT_EQ(m.problems[0].message, name + " takes " + std::to_string(arity) +
                                             (arity == 1 ? " operand" : " operands") + ", not " +
                                             std::to_string(arity + 1));
    };
#define X(name, number, arity, rule, glsl, precedence, flags)                 \
    if (arity >= 0 && Rule::rule != Rule::leaf && Op::name##_ != Op::result_) \
        expect(Op::name##_, #name, arity);
    WR_OPS(X)
#undef X
}

void expect_folds(const Application& a, Numbers& numbers) {
    Module m;
    std::vector<Id> args;
    std::vector<Lanes> values;
    for (size_t i = 0; i < a.operands.size(); ++i) {
        values.push_back(numbers.operand(a, i));
        args.push_back(m.constant(a.operands[i], lanes(values[i], a.operands[i])));
    }
    const Id id = m.add(a.op, args, a.extra, a.wanted);
    ASSERT_NE(id, poison) << text(a) << (m.problems.empty() ? "" : m.problems[0].message);
    ASSERT_TRUE(m.is_constant(id)) << text(a);
    const Lanes got = m.lanes_of(id);
    const Lanes wanted = apply_op(a.op, m.type(id), a.extra, a.operands, values);
    for (size_t i = 0; i < info(m.type(id)).lanes; ++i)
        EXPECT_NEAR(got[i], wanted[i], 1e-12 * (1 + std::abs(wanted[i]))) << text(a) << i;
}

TEST(OpTable, ConstantsFold) {
    Numbers numbers(1);
    for (const Application& a : applications())
        for (int trial = 0; trial < trials; ++trial)
            expect_folds(a, numbers);
}

// An application on leaves, and its tangent when the operands of `mask` vary.
struct Moving {
    Module m;
    std::vector<Id> leaves, speeds;
    Id value = poison, tangent = poison;

    Moving(const Application& a, unsigned mask) {
        ForwardDiff direction(m);
        for (size_t i = 0; i < a.operands.size(); ++i) {
            const Type type = a.operands[i];
            const bool moves = mask >> i & 1;
            leaves.push_back(new_leaf(m, type, "x" + std::to_string(i)));
            speeds.push_back(moves ? new_leaf(m, type, "dx" + std::to_string(i)) : poison);
            if (moves) seed(direction, m, leaves[i], speeds[i]);
        }
        value = m.add(a.op, leaves, a.extra, a.wanted);
        tangent = direction.jvp(value);
    }

    static void seed(ForwardDiff& direction, const Module& m, Id leaf, Id speed) {
        if (m.type(leaf) != Type::mat3_) return direction.seed(leaf, speed);
        for (size_t k = 0; k < 3; ++k)
            direction.seed(m.operands(leaf)[k], m.operands(speed)[k]);
    }

    Lanes at(const std::vector<Lanes>& start, double time) {
        for (size_t i = 0; i < leaves.size(); ++i) {
            Lanes here = start[i];
            if (speeds[i]) {
                const Lanes speed = get_leaf(m, speeds[i]);
                for (size_t k = 0; k < here.size(); ++k)
                    here[k] += time * speed[k];
            }
            set_leaf(m, leaves[i], here);
        }
        return interpret(m, value);
    }
};

bool moves(Type type) {
    return is_float_type(type) || type == Type::mat3_;
}

void expect_derivative(const Application& a, unsigned mask, Numbers& numbers) {
    Moving moving(a, mask);
    ASSERT_NE(moving.value, poison) << text(a);
    std::vector<Lanes> start;
    for (size_t i = 0; i < a.operands.size(); ++i) {
        start.push_back(numbers.operand(a, i));
        Lanes speed{};
        for (size_t k = 0; k < info(a.operands[i]).lanes; ++k)
            speed[k] = numbers.number(-1, 1);
        if (moving.speeds[i]) set_leaf(moving.m, moving.speeds[i], speed);
    }
    constexpr double h = 1e-6;
    const Lanes after = moving.at(start, h), before = moving.at(start, -h);
    moving.at(start, 0);
    const Type type = moving.m.type(moving.value);
    const Lanes got = moving.tangent ? interpret(moving.m, moving.tangent) : Lanes{};
    if (moving.tangent) {
        EXPECT_EQ(moving.m.type(moving.tangent), type) << text(a);
    }
    for (size_t i = 0; i < info(type).lanes; ++i) {
        const double wanted = (after[i] - before[i]) / (2 * h);
        EXPECT_NEAR(got[i], wanted, 1e-4 * std::max(1.0, std::abs(wanted)))
            << text(a) << " lane " << i << " mask " << mask;
    }
}

TEST(OpTable, DerivativesAgreeWithCentralDifferences) {
    Numbers numbers(2);
    for (const Application& a : applications()) {
        if (a.op == Op::detach_) continue;
        for (unsigned mask = 1; mask < 1u << a.operands.size(); ++mask) {
            bool all = true;
            for (size_t i = 0; i < a.operands.size(); ++i)
                all = all && (!(mask >> i & 1) || moves(a.operands[i]));
            for (int trial = 0; all && trial < trials; ++trial)
                expect_derivative(a, mask, numbers);
        }
    }
}

TEST(OpTable, OpsOfZeroDerivativeCostNothing) {
    for (const Application& a : applications()) {
        if (!(info(a.op).flags & WR_FLAG_ZERO_DERIVATIVE) || !moves(a.operands[0])) continue;
        Module m;
        std::vector<Id> args;
        ForwardDiff direction(m);
        for (const Type type : a.operands) {
            args.push_back(m.swizzle(m.input(SurfaceInput::tangent_), "x"));
            if (type == Type::mat3_) args.back() = new_leaf(m, type);
            if (type >= Type::vec2_ && type <= Type::vec4_)
                args.back() = m.swizzle(m.input(SurfaceInput::tangent_),
                                        std::string_view("xyzw").substr(0, info(type).lanes));
        }
        direction.seed(m.input(SurfaceInput::tangent_), new_leaf(m, Type::vec4_));
        const Id value = m.add(a.op, args, a.extra, a.wanted);
        const Id size = m.size();
        EXPECT_EQ(direction.jvp(value), poison) << text(a);
        EXPECT_LE(m.size(), size + 1) << text(a);
    }
}

}  // namespace
}  // namespace wrinkle::test
