// Tests of the modules written by the expansion pass, and of those it refuses. The numbers are
// verified in tests/property, by displacing surfaces.
#include "ir/expand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ir/inspect.h"
#include "ir/interpret.h"
#include "ir/rewrite.h"
#include "ir/value.h"

namespace wrinkle::test {
namespace {

class Expand : public testing::Test {
protected:
    Value input(SurfaceInput which) { return {&m, m.input(which)}; }
    Value number(double v) { return {&m, m.number(v)}; }
    Value tilt(double x) {
        return {&m, m.construct(Type::vec3_,
                                {input(SurfaceInput::uv1_).x().id, m.number(x), m.number(0.8)})};
    }
    Id frame(Value uv, uint32_t method, uint32_t scale) {
        return m.add(Op::frame_, {uv.id}, WR_FRAME(method, scale));
    }
    Value gradient(Op source, Id operand, Id base = 0) {
        return {&m, m.add(source, {operand}, base)};
    }
    Value normal_map(double x, Id frame_id) {
        const Id d = m.add(Op::normal_derivative_, {tilt(x).id, m.number(1), frame_id});
        return gradient(Op::gradient_from_derivative_, d);
    }
    Value add(Value a, Value b) { return op(Op::gradient_add_, a, b); }
    Module result_of(Value v, const ExpandOptions& options = {}) {
        m.outputs = {{"out", WR_PORT_normal, v.id}};
        Module result = expand(m, options);
        EXPECT_EQ(verify(result), "");
        return result;
    }
    Value resolve(Value g) { return {&m, m.add(Op::resolve_, {g.id}, ++resolves)}; }

    Module m;
    uint32_t resolves = 0;
};

size_t count(const Module& module, Op op) {
    const Id root = module.outputs[0].value;
    const std::vector<bool> needed = reachable(module, std::span(&root, 1));
    size_t found = 0;
    for (Id id = 1; id < module.size(); ++id)
        found += needed[id] && module[id].op == op ? 1 : 0;
    return found;
}

size_t opaque_ops(const Module& module) {
    const Id root = module.outputs[0].value;
    const std::vector<bool> needed = reachable(module, std::span(&root, 1));
    size_t found = 0;
    for (Id id = 1; id < module.size(); ++id)
        found += needed[id] && (is_opaque(module[id].op) || module[id].op == Op::detach_) ? 1 : 0;
    return found;
}

TEST_F(Expand, LeavesNothingOpaque) {
    const Value uv = input(SurfaceInput::uv0_);
    Value sum = gradient(Op::gradient_from_height_, (uv.x() * uv.y()).id);
    sum = add(sum, gradient(Op::gradient_from_volume_, m.input(SurfaceInput::position_)));
    sum = add(sum, gradient(Op::gradient_from_normal_, tilt(0.3).id));
    sum = add(sum, normal_map(0.1, frame(uv, WR_FRAME_auto, WR_SCALE_unit)));
    sum = add(sum, normal_map(0.2, frame(uv, WR_FRAME_auto, WR_SCALE_surface)));
    sum = op(Op::gradient_mix_, sum, Value{&m, m.add(Op::gradient_zero_, {})}, number(0.4));
    const Value change = op(Op::ddx_, detach(uv.x() * uv.x())) + op(Op::ddy_, uv.y());
    const Module result = result_of(resolve(sum) * change);
    EXPECT_EQ(opaque_ops(result), 0U);
    EXPECT_TRUE(result.problems.empty());
}

TEST_F(Expand, AddsLayersOfOneFrameBeforeItIsApplied) {
    const Id plain = frame(input(SurfaceInput::uv0_), WR_FRAME_vertex, WR_SCALE_unit);
    const Id tiled = frame(input(SurfaceInput::uv0_) * 8, WR_FRAME_vertex, WR_SCALE_unit);
    const size_t one = count(result_of(resolve(normal_map(0.1, plain))), Op::cross_);
    const Module two = result_of(resolve(add(normal_map(0.1, plain), normal_map(0.2, tiled))));
    EXPECT_EQ(one, 1U);
    EXPECT_EQ(count(two, Op::cross_), 1U);
    EXPECT_EQ(count(two, Op::normalize_), 1U);
}

TEST_F(Expand, DividesNothingWhileTwoDepthsMeet) {
    const Id uv0 = frame(input(SurfaceInput::uv0_), WR_FRAME_vertex, WR_SCALE_unit);
    Value sum = normal_map(0.1, uv0);
    EXPECT_EQ(count(result_of(resolve(sum)), Op::div_), 0U);
    sum = add(sum, normal_map(0.2, uv0));
    EXPECT_EQ(count(result_of(resolve(sum)), Op::div_), 0U);
    sum = add(sum, normal_map(0.3, uv0));
    EXPECT_GT(count(result_of(resolve(sum)), Op::div_), 0U);
}

// A positive factor of a normal is dropped, together with the lower bound of the divisor.
TEST_F(Expand, LeavesOutTheLengthOfANormal) {
    const Id uv0 = frame(input(SurfaceInput::uv0_), WR_FRAME_vertex, WR_SCALE_unit);
    const auto resolved = [&](double factor) {
        const Value normal = tilt(0.1) * factor;
        const Id d = m.add(Op::normal_derivative_, {normal.id, m.number(1), uv0});
        Value sum = gradient(Op::gradient_from_derivative_, d);
        return result_of(resolve(add(sum, gradient(Op::gradient_from_normal_, normal.id))));
    };
    const Module plain = resolved(1), doubled = resolved(2), turned = resolved(-2);
    EXPECT_EQ(count(doubled, Op::mul_), count(plain, Op::mul_));
    EXPECT_GT(count(turned, Op::mul_), count(plain, Op::mul_));
    Surroundings around;
    around.inputs[input_extra(SurfaceInput::normal_, Variant::value)] = {0, 0, 1};
    around.inputs[input_extra(SurfaceInput::tangent_, Variant::value)] = {1, 0, 0, 1};
    around.inputs[input_extra(SurfaceInput::uv1_, Variant::value)] = {0.2, 0};
    around.inputs[input_extra(SurfaceInput::facing_, Variant::value)] = {1};
    // The same normal twice: slopes (0.2, 0.1) / 0.8 from each.
    for (const Module* module : {&plain, &doubled}) {
        const Lanes n = interpret(*module, module->outputs[0].value, around);
        EXPECT_NEAR(n[0] / n[2], 0.5, 1e-12);
        EXPECT_NEAR(n[1] / n[2], 0.25, 1e-12);
    }
}

// n (1 + n.g) - g: the component along the normal is one number.
TEST_F(Expand, ProjectsAVolumeInOneProduct) {
    const Module result =
        result_of(resolve(gradient(Op::gradient_from_volume_, m.input(SurfaceInput::position_))),
                  {true, BackFaces::none});
    EXPECT_EQ(count(result, Op::mul_), 1U);
    EXPECT_EQ(count(result, Op::sub_), 1U);
}

// Next to a vertex frame, which is divided by the normal's length, that length also normalises the
// normal.
TEST_F(Expand, MeasuresTheNormalOnce) {
    const Id uv0 = frame(input(SurfaceInput::uv0_), WR_FRAME_vertex, WR_SCALE_unit);
    const Value volume = gradient(Op::gradient_from_volume_, m.input(SurfaceInput::position_));
    EXPECT_EQ(count(result_of(resolve(volume)), Op::normalize_), 2U);
    const Module both = result_of(resolve(add(normal_map(0.1, uv0), volume)));
    EXPECT_EQ(count(both, Op::normalize_), 1U);
    EXPECT_EQ(count(both, Op::inversesqrt_), 1U);
}

// Storage of a frame, a derivative or a gradient is moved out at its last use.
TEST_F(Expand, KeepsWhatIsReadAgain) {
    Surroundings around;
    around.inputs[input_extra(SurfaceInput::normal_, Variant::value)] = {0, 0, 1};
    around.inputs[input_extra(SurfaceInput::tangent_, Variant::value)] = {1, 0, 0, 1};
    around.inputs[input_extra(SurfaceInput::uv1_, Variant::value)] = {0.2, 0};
    around.inputs[input_extra(SurfaceInput::facing_, Variant::value)] = {1};
    const auto expect = [&](double along_u, double along_v, auto sum_of) {
        m = Module();
        const Id uv0 = frame(input(SurfaceInput::uv0_), WR_FRAME_vertex, WR_SCALE_unit);
        const Value a = normal_map(0.1, uv0), b = normal_map(0.2, uv0);
        const Module result = result_of(resolve(sum_of(a, b)));
        const Lanes n = interpret(result, result.outputs[0].value, around);
        EXPECT_NEAR(n[0] / n[2], along_u, 1e-12);
        EXPECT_NEAR(n[1] / n[2], along_v, 1e-12);
    };
    // The slopes of a are 0.25 and 0.125, of b 0.25 and 0.25.
    expect(0.5, 0.25, [&](Value a, Value) { return add(a, a); });
    expect(0.75, 0.5, [&](Value a, Value b) { return add(add(a, b), a); });
    expect(0.75, 0.625, [&](Value a, Value b) { return add(b, add(b, a)); });
    expect(1.25, 1, [&](Value a, Value b) { return add(add(add(a, b), b), add(a, b)); });
    const auto mix = [&](Value a, Value b) { return op(Op::gradient_mix_, a, b, number(0.5)); };
    expect(0.375, 0.25, [&](Value a, Value b) { return mix(add(a, b), a); });
    expect(0.75, 0.5625,
           [&](Value a, Value b) { return add(mix(add(a, b), a), mix(add(a, b), b)); });
}

// Differentials to the next pixels do not need a uv.
TEST_F(Expand, TakesSlopesOfPixelsAsTheyAre) {
    const Id pixels = frame(input(SurfaceInput::uv0_), WR_FRAME_pixel, WR_SCALE_surface);
    const Id d = m.add(Op::derivative_, {vec2(number(0.3), number(-0.2)).id, pixels});
    const Module result = result_of(resolve(gradient(Op::gradient_from_derivative_, d)));
    EXPECT_TRUE(result.problems.empty());
    Surroundings around;
    around.inputs[input_extra(SurfaceInput::normal_, Variant::value)] = {0, 0, 1};
    around.inputs[input_extra(SurfaceInput::facing_, Variant::value)] = {1};
    around.inputs[input_extra(SurfaceInput::position_, Variant::dx)] = {2, 0, 0};
    around.inputs[input_extra(SurfaceInput::position_, Variant::dy)] = {0, 0.5, 0};
    const Lanes n = interpret(result, result.outputs[0].value, around);
    EXPECT_NEAR(n[0] / n[2], -0.3 / 2, 1e-12);
    EXPECT_NEAR(n[1] / n[2], 0.2 / 0.5, 1e-12);
}

TEST_F(Expand, HoldsMoreFramesThanItHasSlots) {
    Value sum = gradient(Op::gradient_from_height_, m.number(0));
    for (int i = 0; i < 20; ++i) {
        const Value direction{
            &m, m.construct(Type::vec3_, {m.number(1), m.number(i), m.number(0.5 * i)})};
        const Id guessed = m.add(Op::frame_, {m.input(SurfaceInput::uv0_), direction.id},
                                 WR_FRAME(WR_FRAME_guess, WR_SCALE_unit));
        const Id d = m.add(Op::derivative_, {vec2(number(0.01 * i), number(0.02)).id, guessed});
        sum = add(sum, gradient(Op::gradient_from_derivative_, d));
    }
    const Module result = result_of(resolve(sum));
    Surroundings around;
    around.inputs[input_extra(SurfaceInput::normal_, Variant::value)] = {0, 0, 1};
    around.inputs[input_extra(SurfaceInput::facing_, Variant::value)] = {1};
    const Lanes n = interpret(result, result.outputs[0].value, around);
    // Each guess computed by hand: T along the projection of the direction to the plane z = 0, B =
    // n x T.
    double x = 0, y = 0;
    for (int i = 0; i < 20; ++i) {
        const double length = std::hypot(1.0, i), tx = 1 / length, ty = i / length;
        x += tx * 0.01 * i - ty * 0.02;
        y += ty * 0.01 * i + tx * 0.02;
    }
    EXPECT_NEAR(n[0] / n[2], -x, 1e-12);
    EXPECT_NEAR(n[1] / n[2], -y, 1e-12);
}

TEST_F(Expand, DerivesAFrameWithoutTangents) {
    const Value map =
        resolve(normal_map(0.1, frame(input(SurfaceInput::uv0_), WR_FRAME_auto, WR_SCALE_unit)));
    const auto reads_tangent = [](const Module& module) {
        const Id root = module.outputs[0].value;
        const std::vector<bool> needed = reachable(module, std::span(&root, 1));
        for (Id id = 1; id < module.size(); ++id)
            if (needed[id] && module[id].op == Op::input_ &&
                input_of(module[id].extra) == SurfaceInput::tangent_)
                return true;
        return false;
    };
    EXPECT_TRUE(reads_tangent(result_of(map)));
    EXPECT_FALSE(reads_tangent(result_of(map, {false, BackFaces::mirror})));
}

struct Misfit {
    uint32_t method, scale;
    SurfaceInput uv;
    const char* words;
};

TEST_F(Expand, RefusesFramesThatDoNotFit) {
    const Misfit misfits[] = {
        {WR_FRAME_exact, WR_SCALE_unit, SurfaceInput::uv0_, "'exact'"},
        {WR_FRAME_pixel, WR_SCALE_unit, SurfaceInput::uv0_, "'pixel'"},
        {WR_FRAME_vertex, WR_SCALE_surface, SurfaceInput::uv0_, "'surface'"},
        {WR_FRAME_derived, WR_SCALE_surface, SurfaceInput::uv1_, "'surface'"},
        {WR_FRAME_vertex, WR_SCALE_unit, SurfaceInput::uv1_, "'vertex'"},
    };
    m.nodes.push_back({"cloth", m.titles.add("Tangent normal map")});
    m.current_node = 1;
    for (const Misfit& misfit : misfits) {
        m.outputs = {
            {"out", WR_PORT_normal,
             resolve(normal_map(0.1, frame(input(misfit.uv), misfit.method, misfit.scale))).id}};
        const Module result = expand(m, {});
        ASSERT_EQ(result.problems.size(), 1U) << misfit.words;
        EXPECT_NE(result.problems[0].message.find(misfit.words), std::string::npos)
            << result.problems[0].message;
        EXPECT_FALSE(result.problems[0].expected.empty());
        EXPECT_EQ(result.problems[0].node, 1U);
    }
}

TEST_F(Expand, RefusesABaseThatIsNoNormal) {
    const Id base = m.add(Op::base_, {tilt(0.5).id});
    m.outputs = {
        {"out", WR_PORT_normal,
         resolve(gradient(Op::gradient_from_height_, m.input(SurfaceInput::facing_), base)).id}};
    EXPECT_EQ(expand(m, {}).problems.size(), 1U);
}

TEST_F(Expand, TakesTheSurfaceAsABaseInWords) {
    const Id base = m.add(Op::base_, {m.add(Op::normalize_, {m.input(SurfaceInput::normal_)})});
    m.outputs = {
        {"out", WR_PORT_normal,
         resolve(gradient(Op::gradient_from_volume_, m.input(SurfaceInput::position_), base)).id}};
    EXPECT_TRUE(expand(m, {}).problems.empty());
}

// A chain as long as generated code may be: linear time, on a small stack.
TEST_F(Expand, TakesLongChains) {
    Value sum = gradient(Op::gradient_from_volume_, m.input(SurfaceInput::position_));
    for (int i = 1; i <= 20000; ++i) {
        const Value h = input(SurfaceInput::uv0_).x() * (1e-6 * i);
        sum = add(sum, gradient(Op::gradient_from_height_, h.id));
    }
    const Module result = result_of(resolve(sum));
    EXPECT_EQ(opaque_ops(result), 0U);
    EXPECT_LT(result.size(), 200000U);
}

// Hardware would use pixel differences as the footprint of a discontinuous uv, so samples at such a
// uv get explicit derivatives.
TEST_F(Expand, GivesSamplesOfAJumpingUvTheirDerivative) {
    const uint32_t image = m.add_resource({"a.png", "a.png", {}, {}});
    const Value uv = input(SurfaceInput::uv0_);
    const Value texel{&m, m.add(Op::sample_, {uv.id}, image)};
    const Value shift = detach(texel.xy());
    const std::pair<Value, size_t> cases[] = {
        {uv * number(3), 0},
        {uv + detach(input(SurfaceInput::uv1_)), 0},  // continuous, used unchanged
        {uv + texel.xy(), 0},
        {uv + shift, 1},
        {op(Op::fract_, uv), 1},
        {uv - op(Op::floor_, uv), 1}};
    for (const auto& [at, jumping] : cases) {
        const Value again{&m, m.add(Op::sample_, {at.id}, image)};
        const Module result = result_of(again.xyz());
        EXPECT_EQ(count(result, Op::sample_grad_), jumping);
        for (Id id = 1; id < result.size(); ++id) {
            if (result[id].op != Op::sample_grad_) continue;
            EXPECT_EQ(result[result[id].arg[1]].extra,
                      input_extra(SurfaceInput::uv0_, Variant::dx));
        }
    }
}

// A rounding or a choice that is the same at all pixels does not jump between them.
TEST_F(Expand, AUvJumpsOnlyWhereAChoiceVaries) {
    const uint32_t image = m.add_resource({"a.png", "a.png", {}, {}});
    const Value uv = input(SurfaceInput::uv0_), more = uv * number(3);
    const Value amount{&m, m.parameter(m.add_parameter({0, "amount", Type::float_, {2}, true}))};
    const std::pair<Value, size_t> cases[] = {
        {uv * op(Op::floor_, amount), 0},
        {select(greater(amount, 1), uv, more), 0},
        {select(greater(uv.x(), 0.5), uv, more), 1},
        {select(greater(amount, 1), uv, op(Op::fract_, uv)), 1}};
    for (const auto& [at, jumping] : cases) {
        const Value texel{&m, m.add(Op::sample_, {at.id}, image)};
        EXPECT_EQ(count(result_of(texel.xyz()), Op::sample_grad_), jumping);
    }
}

// The loop's value depends on the surface through a captured value without a derivative.
TEST_F(Expand, ALoopOfACapturedStepJumps) {
    const uint32_t image = m.add_resource({"a.png", "a.png", {}, {}});
    const Value uv = input(SurfaceInput::uv0_);
    const Value whole = op(Op::floor_, uv.x() * number(10));
    const std::array types{Type::float_};
    m.begin_region(RegionKind::loop, "", types);
    const std::array results{greater(whole, 3).id, whole.id};
    const Value last{&m, m.apply(m.end_region(results, 3), std::array{number(0).id})[0]};
    const Value texel{&m, m.add(Op::sample_, {(uv + vec2(last, last)).id}, image)};
    EXPECT_EQ(count(result_of(texel.xyz()), Op::sample_grad_), 1U);
}

TEST_F(Expand, ADetachedShiftLeavesAUvInItsSet) {
    const Value uv = input(SurfaceInput::uv0_) + detach(input(SurfaceInput::uv1_));
    const Value g = normal_map(0.5, frame(uv, WR_FRAME_vertex, WR_SCALE_unit));
    EXPECT_TRUE(result_of(resolve(g)).problems.empty());
}

}  // namespace
}  // namespace wrinkle::test
