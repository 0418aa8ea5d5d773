// Tests of substitution, rebuilding, the verifier and the printed form.
#include "ir/rewrite.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ir/expand.h"
#include "ir/inspect.h"
#include "ir/support.h"
#include "ir/value.h"

namespace wrinkle::test {
namespace {

struct RewriteTest : testing::Test {
    Module m;
    Id uv = m.input(SurfaceInput::uv0_);
    Value u{&m, m.swizzle(uv, "x")}, v{&m, m.swizzle(uv, "y")};
    Surroundings around;

    RewriteTest() { around.inputs[input_extra(SurfaceInput::uv0_, Variant::value)] = {0.3, 0.7}; }
    Value n(double value) { return {&m, m.number(value)}; }
    Id replaced(Id root, Id from, Id to) {
        return substitute(m, root, std::span(&from, 1), std::span(&to, 1));
    }
    double value(Id id) {
        m.outputs = {{"value", WR_PORT_float, id}};
        EXPECT_EQ(verify(m), "");
        return interpret(m, id, around)[0];
    }
    // start times factor, `count` times
    Value power(Value start, Value factor, double count) {
        const std::array types{Type::float_, Type::float_};
        const auto s = m.begin_region(RegionKind::loop, "", types);
        const Value x{&m, s[0]}, i{&m, s[1]};
        const std::array results{op(Op::lt_, i, n(count)).id, (x * factor).id, (i + n(1)).id};
        return {&m, m.apply(m.end_region(results, 9), std::array{start.id, m.number(0)})[0]};
    }
};

TEST_F(RewriteTest, SubstitutionFoldsUpwards) {
    const Value x = op(Op::sin_, u * v) + u;
    EXPECT_EQ(replaced(x.id, uv, m.constant(Type::vec2_, std::array{0.0, 5.0})), m.number(0));
    EXPECT_EQ(replaced(x.id, uv, uv), x.id);
    const Id other = m.input(SurfaceInput::uv1_);
    EXPECT_EQ(replaced(x.id, other, uv), x.id);
    EXPECT_EQ(replaced(replaced(x.id, uv, other), other, uv), x.id);
}

TEST_F(RewriteTest, SubstitutionReachesIntoLoopsAndArguments) {
    const Value x = power(v, u, 3);
    const Id doubled = m.add(Op::mul_, {uv, m.number(2)});
    EXPECT_NEAR(value(replaced(x.id, uv, doubled)), 1.4 * 0.6 * 0.6 * 0.6, 1e-14);
}

// A field that contains a loop, read inside another loop at that loop's state.
TEST_F(RewriteTest, LoopsMoveInwards) {
    const Value field = power(n(1), u, 2) + power(n(2), v, 1);
    const std::array types{Type::float_};
    const Id s = m.begin_region(RegionKind::loop, "", types)[0];
    const Value state{&m, s};
    const Value read{&m, replaced(field.id, uv, vec2(state, v).id)};
    const std::array results{op(Op::lt_, state, n(100)).id, (state + read).id};
    const Id sum = m.apply(m.end_region(results, 3), std::array{u.id})[0];
    double wanted = 0.3;
    for (int i = 0; i < 3; ++i)
        wanted += wanted * wanted + 1.4;
    EXPECT_NEAR(value(sum), wanted, 1e-12);
}

TEST_F(RewriteTest, LoopsThatDoNotReadItStayOneValue) {
    const Value still = power(n(2), {&m, m.swizzle(m.input(SurfaceInput::uv1_), "x")}, 2);
    const Value field = still * u;
    const Id s = m.begin_region(RegionKind::loop, "", std::array{Type::vec2_})[0];
    const Id read = replaced(field.id, uv, s);
    EXPECT_EQ(read, (still * Value{&m, m.swizzle(s, "x")}).id);
    m.end_region(std::array{m.literal(Type::bool_, 0), s}, 1);
}

TEST_F(RewriteTest, FieldsInFieldsHaveALimit) {
    Value field = power(n(1), u, 2);
    for (int i = 0; i < 40 && m.problems.empty(); ++i) {
        const Id s = m.begin_region(RegionKind::loop, "", std::array{Type::float_})[0];
        const Value state{&m, s};
        const Id read = replaced(field.id, uv, vec2(state, v).id);
        const std::array results{op(Op::lt_, state, n(9)).id, m.add(Op::add_, {s, read})};
        const auto sum = m.apply(m.end_region(results, 2), std::array{u.id});
        field = {&m, sum.empty() ? u.id : sum[0]};
    }
    ASSERT_FALSE(m.problems.empty());
    EXPECT_EQ(m.problems[0].message, "loops are nested more than 16 deep");
}

TEST_F(RewriteTest, BakingEqualsWritingLiterals) {
    m.nodes.push_back({"bump", m.titles.add("Bump")});
    const Value amount{&m, m.parameter(m.add_parameter({1, "amount", Type::float_, {2}, false}))};
    const Value tint{&m, m.parameter(m.add_parameter({1, "tint", Type::vec2_, {0, 1}, false}))};
    const Value input{&m, m.parameter(m.add_parameter({0, "wear", Type::float_, {3}, true}))};
    m.current_node = 1;
    const Value x = power(u * amount, v * tint.x() + tint.y(), 2) * input;
    m.outputs = {{"height", WR_PORT_height, x.id}};
    m.named = {{x.id, 1, "height", true}, {(u * v).id, 1, "unused", true}};
    const Module baked = expand(m, {.parameters = Parameters::baked});
    EXPECT_EQ(verify(baked), "");
    ASSERT_EQ(baked.outputs.size(), 1u);
    EXPECT_EQ(baked.outputs[0].name, "height");
    EXPECT_NEAR(interpret(baked, baked.outputs[0].value, around)[0], 0.6 * 3, 1e-14);
    const std::string text = print(baked);
    EXPECT_EQ(text.find("amount"), std::string::npos);
    EXPECT_NE(text.find("wear"), std::string::npos);
    ASSERT_EQ(baked.named.size(), 1u);
    EXPECT_EQ(baked.named[0].value, baked.outputs[0].value);
    EXPECT_EQ(baked.origin[baked.outputs[0].value], 1u);
}

TEST_F(RewriteTest, SamplesGetTheirLod) {
    const uint32_t image = m.add_resource({"a.png", "a.png", {}, {}});
    const Id tiled = m.add(Op::mul_, {uv, m.number(4)});
    const Id color = m.add(Op::sample_, {tiled}, image);
    m.outputs = {{"color", WR_PORT_color, m.swizzle(color, "xyz")}};
    const Module explicit_form = explicit_lod(m);
    EXPECT_EQ(verify(explicit_form), "");
    EXPECT_EQ(print(explicit_form).find("sample "), std::string::npos);
    double asked = 0;
    around.image_size = [](uint32_t) { return Lanes{64, 32}; };
    around.texture = [&](uint32_t, double, double, double lod) {
        asked = lod;
        return Lanes{};
    };
    around.inputs[input_extra(SurfaceInput::uv0_, Variant::dx)] = {1 / 64.0, 0};
    around.inputs[input_extra(SurfaceInput::uv0_, Variant::dy)] = {0, 4 / 32.0};
    interpret(explicit_form, explicit_form.outputs[0].value, around);
    EXPECT_NEAR(asked, 4, 1e-12);  // 4 tiles times 4 texels
}

TEST_F(RewriteTest, WithoutDifferentialsImagesAreReadAtLevel0) {
    const uint32_t image = m.add_resource({"a.png", "a.png", {}, {}});
    const Id dx = m.input(SurfaceInput::uv0_, Variant::dx);
    const Id both = m.add(
        Op::add_, {m.add(Op::sample_, {uv}, image), m.add(Op::sample_grad_, {uv, dx, uv}, image)});
    const Id sum = m.add(Op::add_, {m.swizzle(both, "x"), m.swizzle(dx, "y")});
    m.outputs = {{"sum", WR_PORT_float, sum}};
    const Module zero = without_differentials(m);
    EXPECT_EQ(verify(zero), "");
    double lods = 0;
    around.texture = [&](uint32_t, double, double, double lod) {
        lods += std::abs(lod);
        return Lanes{0.25};
    };
    EXPECT_EQ(interpret(zero, zero.outputs[0].value, around)[0], 0.5) << "uv0_dx has no value";
    EXPECT_EQ(lods, 0);
    EXPECT_EQ(print(zero).find("uv0_dx"), std::string::npos) << print(zero);
}

TEST_F(RewriteTest, GivenChangesOfASampleBecomeItsLod) {
    const uint32_t image = m.add_resource({"a.png", "a.png", {}, {}});
    const Id x = m.construct(Type::vec2_, {m.number(0.25), m.number(0)});
    const Id y = m.construct(Type::vec2_, {m.number(0), m.number(0.03125)});
    const Id color = m.add(Op::sample_grad_, {uv, x, y}, image);
    m.outputs = {{"color", WR_PORT_color, m.swizzle(color, "xyz")}};
    const Module explicit_form = explicit_lod(m);
    EXPECT_EQ(print(explicit_form).find("sample_grad"), std::string::npos);
    double asked = 0;
    around.image_size = [](uint32_t) { return Lanes{64, 32}; };
    around.texture = [&](uint32_t, double, double, double lod) {
        asked = lod;
        return Lanes{};
    };
    interpret(explicit_form, explicit_form.outputs[0].value, around);
    EXPECT_NEAR(asked, 4, 1e-12);  // 16 texels along u, 1 along v
}

TEST_F(RewriteTest, ReachableGoesThroughRegions) {
    const Value x = power(n(1), op(Op::cos_, u), 2);
    const Value other = op(Op::sin_, v);
    const auto needed = reachable(m, std::array{x.id});
    EXPECT_TRUE(needed[op(Op::cos_, u).id]);
    EXPECT_FALSE(needed[other.id]);
}

TEST_F(RewriteTest, PrintedFormIsStable) {
    m.nodes.push_back({"weave", m.titles.add("Weave")});
    const Value amount{&m, m.parameter(m.add_parameter({1, "amount", Type::float_, {2}, false}))};
    m.current_node = 1;
    const Id x = m.begin_region(RegionKind::function, "wave", std::array{Type::float_})[0];
    const RegionUse use = m.end_region(std::array{m.add(Op::sin_, {x})});
    const Id y = m.apply(use, std::array{(u * amount).id})[0];
    m.outputs = {{"height", WR_PORT_height, y}};
    EXPECT_EQ(print(m),
              "%1 vec2 = input uv0\n"
              "%2 float = swizzle.x %1\n"
              "%4 float = parameter weave.amount\n"
              "%5 float = region_param 1.0  ; weave\n"
              "%6 float = sin %5  ; weave\n"
              "%7 float = mul %2 %4  ; weave\n"
              "@1 function wave (float) -> %6\n"
              "%8 tuple = call @1 %7  ; weave\n"
              "%9 float = result %8  ; weave\n"
              "output height = %9\n");
}

TEST_F(RewriteTest, TheVerifierFindsImplicitSamplesInRegions) {
    const uint32_t image = m.add_resource({"a.png", "a.png", {}, {}});
    const Id s = m.begin_region(RegionKind::loop, "", std::array{Type::vec2_})[0];
    const Id color = m.add(Op::sample_, {s}, image);
    const std::array results{m.literal(Type::bool_, 1), m.swizzle(color, "xy")};
    const Id last = m.apply(m.end_region(results, 2), std::array{uv})[0];
    m.outputs = {{"uv", WR_PORT_vec2, last}};
    EXPECT_NE(verify(m).find("an implicit derivative inside a region"), std::string::npos);
}

TEST_F(RewriteTest, TheVerifierFindsOutputsInsideRegions) {
    m.outputs = {{"x", WR_PORT_float, m.region_parameter(1, 0, Type::float_)}};
    EXPECT_EQ(verify(m), "output x is inside a region");
}

TEST_F(RewriteTest, TheVerifierFindsOpenFunctions) {
    Region open;
    open.params = {Type::float_};
    open.results = {(u * Value{&m, m.region_parameter(1, 0, Type::float_)}).id};
    const Id tuple = m.apply_region(m.intern_region(open), std::array{v.id});
    m.outputs = {{"x", WR_PORT_float, m.result(tuple, 0)}};
    EXPECT_NE(verify(m).find("a function reads a value of outside"), std::string::npos);
}

TEST_F(RewriteTest, TheVerifierFindsParametersOfNoOne) {
    Region lacking;
    lacking.params = {Type::float_};
    lacking.results = {op(Op::sin_, {&m, m.region_parameter(1, 3, Type::float_)}).id};
    const Id tuple = m.apply_region(m.intern_region(lacking), std::array{v.id});
    m.outputs = {{"x", WR_PORT_float, m.result(tuple, 0)}};
    EXPECT_NE(verify(m).find("a parameter that it does not have"), std::string::npos);
}

}  // namespace
}  // namespace wrinkle::test
