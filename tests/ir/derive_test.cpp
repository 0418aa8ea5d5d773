// Tests of derivatives of complete expressions: chains, functions, loops, textures, singular
// points.
#include "ir/derive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "ir/inspect.h"
#include "ir/jacobian_by_source.h"
#include "ir/support.h"
#include "ir/value.h"

namespace wrinkle::test {
namespace {

constexpr uint32_t uv0 = input_extra(SurfaceInput::uv0_, Variant::value);

struct DeriveTest : testing::Test {
    Module m;
    Id uv = m.input(SurfaceInput::uv0_);
    Value u{&m, m.swizzle(uv, "x")}, v{&m, m.swizzle(uv, "y")};
    Surroundings around;

    DeriveTest() { around.inputs[uv0] = {0.3, 0.7}; }

    Value n(double value) { return {&m, m.number(value)}; }
    double at(Id id, double du, double dv) {
        Surroundings moved = around;
        moved.inputs[uv0][0] += du;
        moved.inputs[uv0][1] += dv;
        return interpret(m, id, moved)[0];
    }
    double derived(Id id, int axis) {
        ForwardDiff direction = direction_along(m, axis_of_uv(SurfaceInput::uv0_, axis));
        const Id tangent = direction.jvp_or_zero(id);
        m.outputs = {{"tangent", WR_PORT_float, tangent}};
        EXPECT_EQ(verify(m), "");
        return interpret(m, tangent, around)[0];
    }
    void expect_derivatives(Value value) {
        constexpr double h = 1e-6;
        for (int axis = 0; axis < 2; ++axis) {
            const double du = axis ? 0 : h, dv = axis ? h : 0;
            const double wanted = (at(value.id, du, dv) - at(value.id, -du, -dv)) / (2 * h);
            EXPECT_NEAR(derived(value.id, axis), wanted, 1e-4 * std::max(1.0, std::abs(wanted)))
                << "axis " << axis;
        }
    }
    std::vector<Value> values(const std::vector<Id>& ids) {
        std::vector<Value> list;
        for (const Id id : ids)
            list.push_back({&m, id});
        return list;
    }
    using Formula = std::function<std::vector<Value>(const std::vector<Value>&)>;
    RegionUse function(size_t params, const Formula& formula) {
        const std::vector<Type> types(params, Type::float_);
        return close(m.begin_region(RegionKind::function, "f", types), formula, 0);
    }
    // formula: the state -> loop condition, next state
    std::vector<Value> loop(uint32_t most, const std::vector<Value>& start,
                            const Formula& formula) {
        const std::vector<Type> types(start.size(), Type::float_);
        return apply(close(m.begin_region(RegionKind::loop, "", types), formula, most), start);
    }
    RegionUse close(const std::vector<Id>& params, const Formula& formula, uint32_t most) {
        std::vector<Id> results;
        for (const Value result : formula(values(params)))
            results.push_back(result.id);
        return m.end_region(results, most);
    }
    std::vector<Value> apply(const RegionUse& use, const std::vector<Value>& args) {
        std::vector<Id> ids;
        for (const Value arg : args)
            ids.push_back(arg.id);
        return values(m.apply(use, ids));
    }
    Value sine(Value x) { return op(Op::sin_, x); }
    Value less(Value a, double b) { return op(Op::lt_, a, n(b)); }
};

TEST_F(DeriveTest, ChainsOfOps) {
    expect_derivatives(sine(u * v * 3.0) / (v + n(2)) + op(Op::sqrt_, u + v * v));
}

TEST_F(DeriveTest, ZeroCostsNothing) {
    ForwardDiff direction = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0));
    const Id other = m.swizzle(m.input(SurfaceInput::uv1_), "x");
    EXPECT_EQ(direction.jvp(m.add(Op::sin_, {other})), poison);
    EXPECT_EQ(direction.jvp(sine(detach(u)).id), poison);
    EXPECT_EQ(direction.jvp_or_zero(other), m.number(0));
}

TEST_F(DeriveTest, DetachedFactorsAreConstant) {
    const Value x = u * detach(u);
    EXPECT_NEAR(derived(x.id, 0), 0.3, 1e-15);
}

TEST_F(DeriveTest, SelectTakesTheChosenOneAndNeverMultiplies) {
    const Value root = op(Op::sqrt_, u - n(0.3));  // infinite derivative where it is not selected
    const Value x = select(greater(u, 0.5), n(1) / root, v * 2.0);
    EXPECT_EQ(derived(x.id, 1), 2);
    EXPECT_EQ(derived(x.id, 0), 0);
}

TEST_F(DeriveTest, SingularPointsHaveDerivativeZero) {
    const Value zero = u - n(0.3), one = u + n(0.7);
    const Value vector = vec2(zero, zero);
    const Value list[] = {op(Op::sqrt_, zero),
                          op(Op::abs_, zero),
                          op(Op::pow_, zero, n(0.5)),
                          op(Op::asin_, one),
                          op(Op::acos_, one),
                          op(Op::length_, vector),
                          op(Op::normalize_, vector).x(),
                          op(Op::atan2_, zero, zero)};
    for (const Value value : list)
        EXPECT_EQ(derived(value.id, 0), 0) << info(m[value.id].op).name;
}

TEST_F(DeriveTest, ScreenDirectionsMoveEveryInterpolatedInput) {
    for (const SurfaceInput input : {SurfaceInput::position_, SurfaceInput::normal_,
                                     SurfaceInput::uv1_, SurfaceInput::uv3_, SurfaceInput::color0_})
        for (const Variant axis : {Variant::dx, Variant::dy}) {
            ForwardDiff direction =
                direction_along(m, axis == Variant::dy ? DiffAxis::screen_y : DiffAxis::screen_x);
            EXPECT_EQ(direction.jvp(m.input(input)), m.input(input, axis));
        }
    ForwardDiff direction = direction_along(m, DiffAxis::screen_x);
    EXPECT_EQ(direction.jvp(m.input(SurfaceInput::facing_)), poison);
    EXPECT_EQ(direction.jvp(m.input(SurfaceInput::view_)), poison);
}

TEST_F(DeriveTest, ProjectedPositionsStayInTheTangentPlane) {
    ForwardDiff direction = direction_along(m, DiffAxis::surface_x);
    const Id change = direction.jvp(m.input(SurfaceInput::position_));
    around.inputs[input_extra(SurfaceInput::normal_, Variant::value)] = {0, 0, 2};
    around.inputs[input_extra(SurfaceInput::position_, Variant::dx)] = {3, 4, 5};
    const Lanes got = interpret(m, change, around);
    EXPECT_NEAR(got[0], 3, 1e-15);
    EXPECT_NEAR(got[1], 4, 1e-15);
    EXPECT_NEAR(got[2], 0, 1e-15);
}

TEST_F(DeriveTest, Functions) {
    const RegionUse f = function(2, [&](const auto& x) {
        return std::vector{sine(x[0] * x[1]), x[0] * x[0], op(Op::floor_, x[1])};
    });
    const auto once = apply(f, {u, v}), twice = apply(f, {once[0], once[1] + v});
    expect_derivatives(once[0]);
    expect_derivatives(once[1]);
    expect_derivatives(twice[0] + twice[1] + twice[2]);
}

TEST_F(DeriveTest, FunctionsOfWhatTheyCapture) {
    const RegionUse f =
        function(1, [&](const auto& x) { return std::vector{x[0] * u + sine(v) * x[0]}; });
    expect_derivatives(apply(f, {n(2)})[0]);
    expect_derivatives(apply(f, {v})[0]);
}

TEST_F(DeriveTest, EightOctavesDeriveOneFunction) {
    const RegionUse f = function(1, [&](const auto& x) { return std::vector{sine(x[0] * 3.0)}; });
    Value sum = n(0);
    for (int octave = 0; octave < 8; ++octave)
        sum = sum + apply(f, {u * std::ldexp(1.0, octave)})[0] * std::ldexp(1.0, -octave);
    const uint32_t before = m.region_count();
    expect_derivatives(sum);
    EXPECT_EQ(m.region_count(), before + 1);
}

// Each function calls the two before it: without a shared memo the work grows like Fibonacci
// numbers.
TEST_F(DeriveTest, NestedFunctionsAreDerivedOnceEach) {
    RegionUse before = function(1, [&](const auto& x) { return std::vector{sine(x[0])}; });
    RegionUse last = function(1, [&](const auto& x) { return std::vector{x[0] * x[0]}; });
    constexpr uint32_t count = 40;
    for (uint32_t i = 0; i < count; ++i) {
        const RegionUse next = function(1, [&](const auto& x) {
            return std::vector{(apply(last, {x[0]})[0] + apply(before, {x[0]})[0]) * 0.5};
        });
        before = last;
        last = next;
    }
    ForwardDiff direction = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0));
    const uint32_t regions = m.region_count();
    EXPECT_NE(direction.jvp(apply(last, {u})[0].id), poison);
    EXPECT_EQ(m.region_count(), regions + count + 2);
}

// The state is (x, y): x is computed from the previous y, so that y becomes active in the first
// pass over the body and x only in the second.
TEST_F(DeriveTest, LoopsSpreadChangeThroughTheirState) {
    const auto state = loop(5, {n(1), n(2), n(0)}, [&](const auto& s) {
        return std::vector{less(s[2], 4), sine(s[1]) * 1.5, s[1] * u + s[0] * 0.25, s[2] + n(1)};
    });
    expect_derivatives(state[0]);
    expect_derivatives(state[1]);
    EXPECT_EQ(derived(state[2].id, 0), 0);
}

TEST_F(DeriveTest, LoopsFromAStateThatChanges) {
    const auto state = loop(3, {u, n(0)}, [&](const auto& s) {
        return std::vector{less(s[1], 9), s[0] * s[0] + n(0.1), s[1] + n(1)};
    });
    expect_derivatives(state[0]);
}

// A parallax march: steps along v until below the height; the marched path is not differentiated,
// the last position is.
TEST_F(DeriveTest, AMarchAlongItsPath) {
    const auto state = loop(32, {n(1), u, v}, [&](const auto& s) {
        const Value height = sine(s[1] * 5.0) * 0.3 + n(0.4);
        return std::vector{op(Op::lt_, height, s[0]), s[0] - n(0.05), s[1] + u * 0.03,
                           s[2] - sine(s[1]) * 0.02};
    });
    expect_derivatives(sine(state[1]) * state[2]);
    EXPECT_LT(at(state[0].id, 0, 0), 0.9);
}

// The inner loop's state becomes active only after the outer one's does.
TEST_F(DeriveTest, LoopsInLoops) {
    const auto outer = loop(3, {n(0.2), n(0.5), n(0)}, [&](const auto& s) {
        const auto inner = loop(2, {s[0], n(0)}, [&](const auto& t) {
            return std::vector{less(t[1], 2), t[0] * s[1] + t[0], t[1] + n(1)};
        });
        return std::vector{less(s[2], 3), inner[0] + s[1] * 0.5, s[0] * u + sine(v), s[2] + n(1)};
    });
    expect_derivatives(outer[0]);
    expect_derivatives(outer[1]);
}

TEST_F(DeriveTest, SiblingLoopsAndALoopInAFunction) {
    const Formula grow = [&](const auto& s) {
        return std::vector{less(s[1], 2), s[0] * 1.5 + u, s[1] + n(1)};
    };
    const Value a = loop(2, {v, n(0)}, grow)[0], b = loop(2, {u, n(0)}, grow)[0];
    expect_derivatives(a * b);
    const RegionUse f = function(1, [&](const auto& x) {
        return std::vector{loop(3, {x[0], n(0)}, [&](const auto& s) {
            return std::vector{less(s[1], 3), s[0] * x[0], s[1] + n(1)};
        })[0]};
    });
    expect_derivatives(apply(f, {u + v})[0]);
}

// Every derivative is through sources only, so the sum of the derivatives by each source, times the
// source's derivative by uv, equals a difference.
struct ChangeBySourceTest : DeriveTest {
    Value zero3 = vec3(n(0), n(0), n(0));
    Value a = op(Op::with_covariance_, {&m, uv}, zero3);
    Value b = op(Op::with_covariance_, vec2(v * 2.0, u), zero3);
    uint32_t image = m.add_resource({"height.png", "height.png", {}, {}});

    ChangeBySourceTest() {
        around.image_size = [](uint32_t) { return Lanes{64, 32}; };
        around.texture = [](uint32_t, double x, double y, double) {
            return Lanes{2 * x - y, 3 * y, 0, 0};
        };
    }
    Lanes difference(Id id, int axis) {
        constexpr double h = 1e-6;
        Surroundings low = around, high = around;
        low.inputs[uv0][static_cast<size_t>(axis)] -= h;
        high.inputs[uv0][static_cast<size_t>(axis)] += h;
        Lanes result = interpret(m, id, high);
        const Lanes before = interpret(m, id, low);
        for (size_t i = 0; i < result.size(); ++i)
            result[i] = (result[i] - before[i]) / (2 * h);
        return result;
    }
    void expect_changes(Value value, size_t sources) {
        const std::vector<SourceJacobian> changes = jacobians_by_source(value);
        ASSERT_EQ(changes.size(), sources);
        for (int axis = 0; axis < 2; ++axis) {
            const Lanes wanted = difference(value.id, axis);
            Lanes sum{};
            for (const SourceJacobian& change : changes) {
                // A source that reads other sources only propagates their derivatives.
                if (change.source != a.id && change.source != b.id) continue;
                const Lanes moved = difference(change.source, axis);
                for (size_t lane = 0; lane < 2; ++lane) {
                    const Scaled& column = change.columns[lane];
                    if (!column.vector) continue;
                    const Lanes vector = interpret(m, column.vector.id, around);
                    const double factor =
                        column.factor ? interpret(m, column.factor.id, around)[0] : 1;
                    for (size_t i = 0; i < sum.size(); ++i)
                        sum[i] += vector[i] * factor * moved[lane];
                }
            }
            for (size_t i = 0; i < 3; ++i)
                EXPECT_NEAR(sum[i], wanted[i], 1e-5) << "axis " << axis << ", number " << i;
        }
    }
};

TEST_F(ChangeBySourceTest, OfSumsAndMultiplesOfVectors) {
    const Value t = vec3(n(1), n(0.2), n(0.1)), w = vec3(n(-0.3), n(1), n(0.4));
    const Value first = t * (a.x() * 0.5) + w * a.y();
    const Value second = (t * b.x() - w * (b.y() * a.x())) * a.y() + cross(first, w);
    expect_changes(-(first * b.y()) - second, 2);
    expect_changes(detach(normalize(first + second)), 2);
}

TEST_F(ChangeBySourceTest, OfOneThatIsMetTwiceAndOneBelowAnother) {
    const Value again = op(Op::with_covariance_, a * a.x() + b, zero3);
    expect_changes(vec3(again, a.y()) + vec3(a, again.x()), 3);
}

TEST_F(ChangeBySourceTest, ThroughFunctionsLoopsAndPictures) {
    const RegionUse f = function(2, [&](const auto& x) {
        return std::vector{sine(x[0]) * x[1], x[1] * x[1]};
    });
    const std::vector<Value> called = apply(f, {a.x() + b.y(), b.x()});
    const std::vector<Value> state = loop(4, {called[0], n(1), n(0)}, [&](const auto& s) {
        return std::vector{less(s[2], 3), s[0] * a.y() + s[1] * 0.5, s[1] * b.x(), s[2] + n(1)};
    });
    const Value read{&m, m.swizzle(m.add(Op::sample_lod_, {(a + b).id, n(0).id}, image), "xy")};
    expect_changes(vec3(read * called[1], state[0] * state[1]), 2);
}

struct TextureTest : DeriveTest {
    uint32_t image = m.add_resource({"height.png", "height.png", {}, {}});
    TextureTest() {
        around.image_size = [](uint32_t) { return Lanes{64, 32}; };
        around.texture = [](uint32_t, double u, double v, double) {
            return Lanes{u * u + 3 * v, 7 * u * v, 0, 1};
        };
    }
    Value red(Op o, std::initializer_list<Id> args) {
        return {&m, m.swizzle(m.add(o, args, image), "x")};
    }
    // The forward difference of u^2 over a step is 2u + step.
    void expect_step(Value height, double texels) {
        EXPECT_NEAR(derived(height.id, 0), 2 * 0.3 + texels / 64, 1e-12);
        EXPECT_NEAR(derived(height.id, 1), 3, 1e-12);
    }
};

TEST_F(TextureTest, ForwardDifferencesOverOneTexelOfTheLevel) {
    expect_step(red(Op::sample_lod_, {uv, m.number(0)}), 1);
    expect_step(red(Op::sample_lod_, {uv, m.number(3)}), 8);
    expect_step(red(Op::sample_lod_, {uv, m.number(-4)}), 1);
    expect_step(red(Op::sample_lod_, {uv, m.number(40)}), 64);
}

TEST_F(TextureTest, TheLevelOfGivenDifferentials) {
    const Id dx = m.constant(Type::vec2_, std::array{4 / 64.0, 0.0});
    const Id dy = m.constant(Type::vec2_, std::array{0.0, 2 / 32.0});
    expect_step(red(Op::sample_grad_, {uv, dx, dy}), 4);
}

TEST_F(TextureTest, TheLevelOfThePixel) {
    around.inputs[input_extra(SurfaceInput::uv0_, Variant::dx)] = {2 / 64.0, 0};
    around.inputs[input_extra(SurfaceInput::uv0_, Variant::dy)] = {0, 16 / 32.0};
    expect_step(red(Op::sample_, {uv}), 16);
    around.inputs.erase(input_extra(SurfaceInput::uv0_, Variant::dx));
    around.inputs.erase(input_extra(SurfaceInput::uv0_, Variant::dy));
    expect_step(red(Op::sample_, {uv}), 1);
}

TEST_F(TextureTest, TheChangeOfUvMultiplies) {
    const Value tiled{&m, m.add(Op::mul_, {uv, m.number(5)})};
    around.texture = [](uint32_t, double u, double v, double) { return Lanes{2 * u - v, 0, 0, 0}; };
    const Value height = red(Op::sample_lod_, {tiled.id, m.number(0)});
    EXPECT_NEAR(derived(height.id, 0), 10, 1e-11);
    EXPECT_NEAR(derived(height.id, 1), -5, 1e-11);
}

TEST_F(TextureTest, AFixedPlaceDoesNotChange) {
    ForwardDiff direction = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0));
    const Id there = m.constant(Type::vec2_, std::array{0.5, 0.5});
    EXPECT_EQ(direction.jvp(red(Op::sample_lod_, {there, u.id}).id), poison);
    EXPECT_EQ(direction.jvp(m.add(Op::image_size_, {}, image)), poison);
}

}  // namespace
}  // namespace wrinkle::test
