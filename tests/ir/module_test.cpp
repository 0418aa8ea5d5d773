// Tests of building expressions: equal ones are interned, trivial ones simplified, invalid ones
// reported.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "ir/support.h"

namespace wrinkle::test {
namespace {

struct ModuleTest : testing::Test {
    Module m;
    Id f = m.swizzle(m.input(SurfaceInput::uv1_), "x");
    Id g = m.swizzle(m.input(SurfaceInput::uv1_), "y");
    Id v = m.input(SurfaceInput::position_);
    Id w = m.input(SurfaceInput::normal_);
    Id uv = m.input(SurfaceInput::uv0_);
    Id yes = m.add(Op::lt_, {f, g});

    Id add(Op op, std::initializer_list<Id> args, uint32_t extra = 0) {
        return m.add(op, args, extra);
    }
    Id n(double value) { return m.number(value); }
    Id vec3(double value) { return m.constant(Type::vec3_, std::array{value, value, value}); }
    std::string refusal(Op op, std::initializer_list<Id> args, uint32_t extra = 0,
                        Type type = Type::poison_) {
        m.problems.clear();
        EXPECT_EQ(m.add(op, args, extra, type), poison);
        return m.problems.size() == 1 ? m.problems[0].message : "";
    }
};

TEST_F(ModuleTest, EqualExpressionsAreOneValue) {
    const Id once = add(Op::add_, {f, g});
    const Id size = m.size();
    EXPECT_EQ(add(Op::add_, {f, g}), once);
    EXPECT_EQ(m.size(), size);
    EXPECT_NE(add(Op::sub_, {f, g}), once);
    EXPECT_NE(m.input(SurfaceInput::uv0_, Variant::dx), uv);
}

// Users beyond the length of a chain are stored in the hash table, which grows meanwhile.
TEST_F(ModuleTest, EqualOnesAreFoundAmongManyReadersOfOneValue) {
    constexpr size_t readers = 5000;
    std::vector<Id> numbers, sums;
    for (size_t i = 0; i < readers; ++i)
        numbers.push_back(m.number(static_cast<double>(i) + 2));
    const Id x = m.component(m.input(SurfaceInput::uv0_), 0);
    for (const Id number : numbers)
        sums.push_back(m.add(Op::add_, {x, number}));
    const uint32_t size = m.size();
    EXPECT_EQ(std::set<Id>(sums.begin(), sums.end()).size(), readers);
    for (size_t i = 0; i < readers; ++i) {
        EXPECT_EQ(m.add(Op::add_, {x, numbers[i]}), sums[i]);
        EXPECT_EQ(m.number(static_cast<double>(i) + 2), numbers[i]);
    }
    EXPECT_EQ(m.size(), size);
}

TEST_F(ModuleTest, WrittenOrderIsKept) {
    EXPECT_NE(add(Op::add_, {f, g}), add(Op::add_, {g, f}));
}

TEST_F(ModuleTest, LiteralsAreToldApartByTheirBits) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_NE(n(0.0), n(-0.0));
    EXPECT_EQ(n(nan), n(nan));
    EXPECT_NE(n(1), m.literal(Type::int_, 1));
    EXPECT_EQ(n(0.1), n(0.1));
}

TEST_F(ModuleTest, IntegerLiteralsFitTheirType) {
    EXPECT_EQ(m[m.literal(Type::int_, 1e300)].value, 2147483647.0);
    EXPECT_EQ(m[m.literal(Type::uint_, -5)].value, 0.0);
    EXPECT_EQ(m[m.literal(Type::int_, std::nan(""))].value, 0.0);
    EXPECT_EQ(m[m.literal(Type::bool_, 7)].value, 1.0);
}

TEST_F(ModuleTest, ArithmeticWithZeroAndOne) {
    EXPECT_EQ(add(Op::add_, {f, n(0)}), f);
    EXPECT_EQ(add(Op::add_, {n(0), f}), f);
    EXPECT_EQ(add(Op::add_, {v, n(0)}), v);
    EXPECT_EQ(add(Op::add_, {v, vec3(0)}), v);
    EXPECT_EQ(add(Op::sub_, {f, n(0)}), f);
    EXPECT_EQ(add(Op::sub_, {f, f}), n(0));
    EXPECT_EQ(add(Op::sub_, {n(0), f}), add(Op::neg_, {f}));
    EXPECT_EQ(add(Op::mul_, {f, n(1)}), f);
    EXPECT_EQ(add(Op::mul_, {f, n(49 * (1.0 / 49))}), f);  // 1 less a bit of a double
    EXPECT_NE(add(Op::mul_, {f, n(1 - 1e-7)}), f);
    EXPECT_EQ(add(Op::mul_, {v, n(0)}), vec3(0));
    EXPECT_EQ(add(Op::mul_, {n(0), v}), vec3(0));
    EXPECT_EQ(add(Op::mul_, {f, n(-1)}), add(Op::neg_, {f}));
    EXPECT_EQ(add(Op::div_, {v, n(1)}), v);
    EXPECT_EQ(add(Op::neg_, {add(Op::neg_, {f})}), f);
    EXPECT_EQ(add(Op::mul_, {f, vec3(1)}), m.construct(Type::vec3_, {f, f, f}));
    EXPECT_EQ(add(Op::add_, {vec3(0), f}), m.construct(Type::vec3_, {f, f, f}));
}

TEST_F(ModuleTest, ChoicesThatAreNone) {
    EXPECT_EQ(add(Op::select_, {yes, f, f}), f);
    EXPECT_EQ(add(Op::select_, {m.literal(Type::bool_, 1), f, g}), f);
    EXPECT_EQ(add(Op::select_, {m.literal(Type::bool_, 0), f, g}), g);
    EXPECT_EQ(add(Op::mix_, {f, g, n(0)}), f);
    EXPECT_EQ(add(Op::mix_, {f, g, n(1)}), g);
    EXPECT_EQ(add(Op::mix_, {f, f, g}), f);
    EXPECT_EQ(add(Op::min_, {f, f}), f);
    EXPECT_EQ(add(Op::and_, {yes, m.literal(Type::bool_, 1)}), yes);
    EXPECT_EQ(add(Op::or_, {yes, m.literal(Type::bool_, 0)}), yes);
    EXPECT_EQ(add(Op::not_, {add(Op::not_, {yes})}), yes);
}

TEST_F(ModuleTest, VectorsThatAreZero) {
    EXPECT_EQ(add(Op::dot_, {v, vec3(0)}), n(0));
    EXPECT_EQ(add(Op::cross_, {vec3(0), v}), vec3(0));
    EXPECT_EQ(add(Op::cross_, {v, v}), vec3(0));
    EXPECT_EQ(add(Op::detach_, {n(3)}), n(3));
    const Id detached = add(Op::detach_, {f});
    EXPECT_EQ(add(Op::detach_, {detached}), detached);
}

TEST_F(ModuleTest, WhatIsUnitNeedsNoGuard) {
    const Id unit = add(Op::normalize_, {v}), facing = m.input(SurfaceInput::facing_);
    const Id turned = add(Op::mul_, {unit, facing});
    for (const Id normal : {unit, turned, add(Op::neg_, {unit}), add(Op::detach_, {turned})}) {
        EXPECT_EQ(add(Op::dot_, {normal, normal}), n(1));
        EXPECT_EQ(add(Op::length_, {normal}), n(1));
        EXPECT_EQ(add(Op::normalize_, {normal}), normal);
    }
    EXPECT_EQ(add(Op::dot_, {unit, turned}), facing);
    EXPECT_EQ(add(Op::dot_, {turned, unit}), facing);
    EXPECT_EQ(add(Op::sign_nonzero_, {facing}), facing);
    EXPECT_EQ(add(Op::mul_, {turned, facing}), unit);
    EXPECT_EQ(add(Op::abs_, {turned}), add(Op::abs_, {unit}));
    EXPECT_EQ(m[add(Op::dot_, {v, v})].op, Op::dot_);
    EXPECT_EQ(m[add(Op::dot_, {unit, v})].op, Op::dot_);
    const Id stretched = add(Op::mul_, {unit, f});
    EXPECT_EQ(m[add(Op::normalize_, {stretched})].op, Op::normalize_);
}

TEST_F(ModuleTest, VectorsWithZerosGoNumberByNumber) {
    const Id along_x = m.construct(Type::vec2_, {f, n(0)});
    const Id x = m.swizzle(uv, "x"), y = m.swizzle(uv, "y");
    EXPECT_EQ(add(Op::dot_, {uv, along_x}), add(Op::mul_, {x, f}));
    EXPECT_EQ(add(Op::mul_, {along_x, g}), m.construct(Type::vec2_, {add(Op::mul_, {f, g}), n(0)}));
    EXPECT_EQ(add(Op::add_, {uv, along_x}), m.construct(Type::vec2_, {add(Op::add_, {x, f}), y}));
    EXPECT_EQ(add(Op::sub_, {uv, along_x}), m.construct(Type::vec2_, {add(Op::sub_, {x, f}), y}));
    const Id mirror = m.construct(Type::vec2_, {n(1), n(-1)});
    EXPECT_EQ(add(Op::mul_, {uv, mirror}), m.construct(Type::vec2_, {x, add(Op::neg_, {y})}));
    EXPECT_EQ(m[add(Op::add_, {uv, mirror})].op, Op::add_);
    EXPECT_EQ(m[add(Op::mul_, {uv, m.construct(Type::vec2_, {f, g})})].op, Op::mul_);
}

TEST_F(ModuleTest, SmallPowersAreProducts) {
    const Id square = add(Op::mul_, {f, f});
    EXPECT_EQ(add(Op::pow_, {f, n(1)}), f);
    EXPECT_EQ(add(Op::pow_, {f, n(2)}), square);
    EXPECT_EQ(add(Op::pow_, {f, n(3)}), add(Op::mul_, {square, f}));
    EXPECT_EQ(add(Op::pow_, {f, n(4)}), add(Op::mul_, {square, square}));
    EXPECT_EQ(m[add(Op::pow_, {v, vec3(3)})].op, Op::mul_);
    EXPECT_EQ(m[add(Op::pow_, {f, n(5)})].op, Op::pow_);
}

TEST_F(ModuleTest, BoundsThatHoldAnyway) {
    const Id least = add(Op::max_, {f, n(1)});
    EXPECT_EQ(add(Op::max_, {least, n(0.5)}), least);
    EXPECT_EQ(m[add(Op::max_, {least, n(2)})].op, Op::max_);
    EXPECT_NE(add(Op::max_, {least, n(2)}), least);
    for (const Id found : {add(Op::dot_, {v, v}), add(Op::mul_, {f, f}), add(Op::length_, {v}),
                           add(Op::abs_, {f}), add(Op::sqrt_, {least})})
        EXPECT_EQ(add(Op::max_, {found, n(0)}), found);
    EXPECT_EQ(add(Op::max_, {add(Op::sqrt_, {least}), n(1)}), add(Op::sqrt_, {least}));
    const Id whole = add(Op::to_int_, {f}), none = m.literal(Type::int_, 0);  // squares wrap
    EXPECT_EQ(m[add(Op::max_, {add(Op::mul_, {whole, whole}), none})].op, Op::max_);
    for (const Id open : {add(Op::dot_, {v, w}), add(Op::mul_, {f, g}), f})
        EXPECT_EQ(m[add(Op::max_, {open, n(0)})].op, Op::max_);
}

TEST_F(ModuleTest, ComponentsOfComponents) {
    EXPECT_EQ(m.swizzle(v, "xyz"), v);
    EXPECT_EQ(m.swizzle(m.swizzle(v, "zyx"), "x"), m.swizzle(v, "z"));
    const Id made = m.construct(Type::vec3_, {f, uv});
    EXPECT_EQ(m.swizzle(made, "x"), f);
    EXPECT_EQ(m.swizzle(made, "yz"), uv);
    EXPECT_EQ(m.construct(Type::vec2_, {m.swizzle(uv, "x"), m.swizzle(uv, "y")}), uv);
    EXPECT_EQ(m.construct(Type::vec2_, {m.swizzle(v, "z"), m.swizzle(v, "x")}), m.swizzle(v, "zx"));
    const Id matrix = m.construct(Type::mat3_, {v, w, v});
    EXPECT_EQ(add(Op::column_, {matrix}, 1), w);
}

// The double nearest to a quarter turn has a cosine of 6e-17.
TEST_F(ModuleTest, QuarterTurnsHaveExactZeros) {
    constexpr double pi = 3.14159265358979323846;
    EXPECT_EQ(add(Op::cos_, {n(pi / 2)}), n(0));
    EXPECT_EQ(add(Op::sin_, {n(-pi)}), n(0));
    EXPECT_NE(add(Op::cos_, {n(pi / 2 - 1e-12)}), n(0));
    EXPECT_EQ(add(Op::sin_, {n(pi / 2)}), n(1));
    EXPECT_NE(add(Op::sin_, {n(1e-16)}), n(0));
}

TEST_F(ModuleTest, WhatIsUndefinedIsNotFolded) {
    EXPECT_EQ(m[add(Op::div_, {n(1), n(0)})].op, Op::div_);
    EXPECT_EQ(m[add(Op::sqrt_, {n(-1)})].op, Op::sqrt_);
    EXPECT_EQ(m[add(Op::log_, {n(0)})].op, Op::log_);
    EXPECT_EQ(m[add(Op::inversesqrt_, {n(0)})].op, Op::inversesqrt_);
    EXPECT_EQ(m[add(Op::pow_, {n(-2), n(3)})].op, Op::pow_);
    EXPECT_EQ(m[add(Op::asin_, {n(1.5)})].op, Op::asin_);
    EXPECT_EQ(m[add(Op::atan2_, {n(0), n(0)})].op, Op::atan2_);
    EXPECT_EQ(m[add(Op::normalize_, {vec3(0)})].op, Op::normalize_);
    EXPECT_EQ(m[add(Op::mul_, {n(1e200), n(1e200)})].op, Op::mul_);
    EXPECT_EQ(m[add(Op::dot_, {vec3(1e200), vec3(1e200)})].op, Op::dot_);
    const Id word = m.literal(Type::int_, 1), many = m.literal(Type::int_, 32);
    EXPECT_EQ(m[add(Op::shift_left_, {word, many})].op, Op::shift_left_);
}

TEST_F(ModuleTest, CornersOfTheSemantics) {
    EXPECT_EQ(add(Op::mod_, {n(-0.25), n(1)}), n(0.75));
    EXPECT_EQ(add(Op::sign_, {n(0)}), n(0));
    EXPECT_EQ(add(Op::sign_nonzero_, {n(0)}), n(1));
    EXPECT_EQ(add(Op::sign_nonzero_, {n(-2)}), n(-1));
    EXPECT_EQ(add(Op::step_, {n(1), n(1)}), n(1));
    const Id most = m.literal(Type::int_, 2147483647), one = m.literal(Type::int_, 1);
    EXPECT_EQ(add(Op::add_, {most, one}), m.literal(Type::int_, -2147483648.0));
    const Id all = m.literal(Type::uint_, 4294967295.0);
    EXPECT_EQ(add(Op::mul_, {all, all}), m.literal(Type::uint_, 1));
    EXPECT_EQ(add(Op::shift_right_, {m.literal(Type::int_, -8), one}), m.literal(Type::int_, -4));
}

TEST_F(ModuleTest, ParametersAreNeverLookedAt) {
    const Id one = m.parameter(m.add_parameter({0, "amount", Type::float_, {1}, false}));
    EXPECT_EQ(m[add(Op::mul_, {f, one})].op, Op::mul_);
    EXPECT_EQ(m[add(Op::add_, {one, n(2)})].op, Op::add_);
}

TEST_F(ModuleTest, PoisonIsSilent) {
    EXPECT_EQ(add(Op::add_, {f, poison}), poison);
    EXPECT_EQ(add(Op::normalize_, {add(Op::cross_, {poison, v})}), poison);
    EXPECT_EQ(m.result(poison, 0), poison);
    EXPECT_TRUE(m.problems.empty());
}

TEST_F(ModuleTest, TypesThatDoNotFit) {
    EXPECT_EQ(refusal(Op::add_, {uv, v}),
              "add of (vec2, vec3) makes no sense: it takes floats or vectors of one size");
    EXPECT_EQ(refusal(Op::mul_, {f, yes}),
              "mul of (float, bool) makes no sense: it takes floats or vectors of one size");
    EXPECT_EQ(refusal(Op::cross_, {uv, uv}),
              "cross of (vec2, vec2) makes no sense: it takes vec3, vec3");
    EXPECT_EQ(refusal(Op::dot_, {f, g}),
              "dot of (float, float) makes no sense: it takes vectors of one size");
    EXPECT_EQ(refusal(Op::select_, {f, f, g}),
              "select of (float, float, float) makes no sense: it takes a bool and two values of "
              "one type");
    EXPECT_EQ(refusal(Op::and_, {yes, f}), "and of (bool, float) makes no sense: it takes bools");
    EXPECT_EQ(refusal(Op::lt_, {v, w}),
              "lt of (vec3, vec3) makes no sense: it takes two scalars of one type");
    EXPECT_EQ(refusal(Op::bit_and_, {f, g}),
              "bit_and of (float, float) makes no sense: it takes integers of one type");
    EXPECT_EQ(refusal(Op::shift_left_, {m.literal(Type::int_, 1), f}),
              "shift_left of (int, float) makes no sense: it takes integers of one type");
    EXPECT_EQ(refusal(Op::to_uint_, {f}), "to_uint of (float) makes no sense: it takes int");
    EXPECT_EQ(refusal(Op::construct_, {f, g}, 0, Type::vec3_),
              "construct of (float, float) makes no sense: it takes as many lanes as the vector "
              "has");
    EXPECT_EQ(refusal(Op::sqrt_, {f, g}), "sqrt takes 1 operand, not 2");
}

TEST_F(ModuleTest, NumbersThatAPluginMayGetWrong) {
    EXPECT_EQ(refusal(static_cast<Op>(9999), {f}), "there is no op 9999");
    EXPECT_EQ(refusal(Op::loop_, {f}), "'loop' is not written as an op");
    EXPECT_EQ(refusal(Op::parameter_, {}, 77), "'parameter' is not written as an op");
    EXPECT_EQ(refusal(Op::construct_, {f, f, f, f, f}, 0, Type::vec4_),
              "construct takes at most 4 operands");
    EXPECT_EQ(refusal(Op::sqrt_, {f, f, f, f, f}), "sqrt takes 1 operand, not 5");
    EXPECT_EQ(refusal(Op::neg_, {123456}), "neg is given a value that does not exist");
    EXPECT_EQ(refusal(Op::sample_, {uv}, 3), "sample is given an image that does not exist");
    const Id matrix = m.construct(Type::mat3_, {v, w, v});
    EXPECT_EQ(refusal(Op::column_, {matrix}, 3), "a mat3 has no column 3");
    EXPECT_EQ(refusal(Op::swizzle_, {uv}, 0x21),
              "swizzle of (vec2) makes no sense: it takes components that a vector has");
    EXPECT_EQ(refusal(Op::gradient_from_height_, {f}, f),
              "gradient_from_height is given a base that is none");
}

TEST_F(ModuleTest, ProblemsAndOriginsNameTheNode) {
    m.nodes.push_back({"weave", m.titles.add("Weave")});
    m.current_node = 1;
    const Id sum = add(Op::add_, {f, g});
    refusal(Op::add_, {uv, v});
    EXPECT_EQ(m.problems[0].node, 1u);
    m.current_node = 0;
    EXPECT_EQ(add(Op::add_, {f, g}), sum);
    EXPECT_EQ(m.origin[sum], 1u);
}

struct GradientTest : ModuleTest {
    Id flat = m.add(Op::gradient_zero_, {});
    Id a = m.add(Op::gradient_from_height_, {f}, poison);
    Id b = m.add(Op::gradient_from_volume_, {v}, poison);
};

TEST_F(GradientTest, FlatLayersDisappear) {
    EXPECT_EQ(add(Op::gradient_add_, {a, flat}), a);
    EXPECT_EQ(add(Op::gradient_add_, {flat, a}), a);
    EXPECT_EQ(add(Op::gradient_scale_, {flat, f}), flat);
    EXPECT_EQ(add(Op::gradient_scale_, {a, n(1)}), a);
    EXPECT_EQ(add(Op::gradient_scale_, {a, n(0)}), flat);
    EXPECT_EQ(add(Op::gradient_mix_, {a, b, n(1)}), b);
    EXPECT_EQ(add(Op::gradient_mix_, {flat, b, f}), add(Op::gradient_scale_, {b, f}));
}

TEST_F(GradientTest, FlatLayersKeepTheirBase) {
    const Id base = m.add(Op::base_, {m.add(Op::resolve_, {a}, 1)});
    const Id on_base = m.add(Op::gradient_from_height_, {f}, base);
    const Id nothing = add(Op::gradient_scale_, {on_base, n(0)});
    EXPECT_NE(nothing, flat);
    EXPECT_EQ(m[nothing].extra, base);
    EXPECT_EQ(add(Op::gradient_add_, {flat, nothing}), nothing);
    EXPECT_EQ(add(Op::gradient_add_, {nothing, on_base}), on_base);
    EXPECT_EQ(m[add(Op::gradient_mix_, {flat, on_base, n(0)})].extra, base);
    EXPECT_EQ(add(Op::gradient_add_, {nothing, a}), poison) << "bases differ";
}

TEST_F(GradientTest, AmountsMultiply) {
    const Id twice = add(Op::gradient_scale_, {add(Op::gradient_scale_, {a, f}), g});
    EXPECT_EQ(twice, add(Op::gradient_scale_, {a, add(Op::mul_, {f, g})}));
}

TEST_F(GradientTest, BasesDoNotMix) {
    m.nodes.push_back({"first", m.titles.add("Resolve")});
    m.nodes.push_back({"second", m.titles.add("Resolve")});
    m.current_node = 1;
    const Id normal = m.add(Op::resolve_, {a}, 1);
    const Id base = m.add(Op::base_, {normal});
    m.current_node = 2;
    const Id other = m.add(Op::base_, {m.add(Op::resolve_, {a}, 2)});
    EXPECT_NE(base, other);
    const Id on_normal = m.add(Op::gradient_from_height_, {f}, base);
    EXPECT_NE(on_normal, a);
    EXPECT_EQ(m[m.add(Op::gradient_scale_, {on_normal, f})].extra, base);
    EXPECT_EQ(refusal(Op::gradient_add_, {a, on_normal}),
              "adds gradients of different bases: one on the surface, one on the normal of node "
              "'first'");
    const Id on_other = m.add(Op::gradient_from_height_, {f}, other);
    EXPECT_EQ(refusal(Op::gradient_mix_, {on_normal, on_other, f}),
              "mixes gradients of different bases: one on the normal of node 'first', one on the "
              "normal of node 'second'");
}

TEST(ModuleTables, EqualResourcesMerge) {
    Module m;
    Resource image;
    image.file = "a.png";
    image.readers.push_back({1, "image"});
    EXPECT_EQ(m.add_resource(image), 0u);
    image.readers[0].node = 2;
    EXPECT_EQ(m.add_resource(image), 0u);
    ASSERT_EQ(m.resources[0].readers.size(), 2u);
    EXPECT_EQ(m.resources[0].readers[1].node, 2u);
    image.file = "b.png";
    EXPECT_EQ(m.add_resource(image), 1u);
}

}  // namespace
}  // namespace wrinkle::test
