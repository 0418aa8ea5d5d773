// Tests of long chains: every pass iterates over a few instructions, on a stack of 256 KB.
#include <gtest/gtest.h>

#include "ir/derive.h"
#include "ir/expand.h"
#include "ir/compact.h"
#include "ir/inspect.h"
#include "ir/rewrite.h"
#include "ir/support.h"
#include "ir/value.h"
#include "support/small_stack.h"

namespace wrinkle::test {
namespace {

constexpr int length = 100'000;
constexpr int shorter = 20'000;  // 13 bytes of stack for each link: enough to detect recursion

// height = ((uv.x * a + uv.y) * a + uv.y) * a ...
Module chain(int count) {
    Module m;
    m.nodes.push_back({"bump", m.titles.add("Bump")});
    const Value a{&m, m.parameter(m.add_parameter({1, "amount", Type::float_, {0.5}, false}))};
    const Value uv{&m, m.input(SurfaceInput::uv0_)};
    Value x = uv.x();
    for (int i = 0; i < count; ++i)
        x = x * a + uv.y();
    m.outputs = {{"height", WR_PORT_height, x.id}};
    return m;
}

void pass_through_every_pass() {
    Module m = chain(length);
    const Id written = m.size();
    EXPECT_LT(written, 2u * length + 10);
    EXPECT_EQ(verify(m), "");
    ForwardDiff direction = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 1));
    EXPECT_NE(direction.jvp(m.outputs[0].value), poison);
    EXPECT_LT(m.size() - written, 2u * length + 10);
    const Id from = m.input(SurfaceInput::uv0_), to = m.input(SurfaceInput::uv1_);
    const Id before = m.size();
    EXPECT_NE(substitute(m, m.outputs[0].value, std::span(&from, 1), std::span(&to, 1)),
              m.outputs[0].value);
    EXPECT_LT(m.size() - before, 2u * length + 10);
    const Module baked = expand(m, {.parameters = Parameters::baked});
    EXPECT_LT(baked.size(), 2u * length + 10);
    EXPECT_EQ(verify(explicit_lod(baked)), "");
    EXPECT_GT(print(baked).size(), size_t{length});
    const Lanes half =
        interpret(m, m.outputs[0].value,
                  {{{input_extra(SurfaceInput::uv0_, Variant::value), {1, 3}}}, {}, {}});
    EXPECT_NEAR(half[0], 6, 1e-12);  // x = x / 2 + 3
}

TEST(Chain, EveryPass) {
    on_small_stack(pass_through_every_pass);
}

// A chain inside a function and inside a loop; the chain's derivative passes through both.
void chain_in_regions() {
    Module m;
    const Id x = m.begin_region(RegionKind::function, "f", std::array{Type::float_})[0];
    Value sum{&m, x};
    for (int i = 0; i < shorter; ++i)
        sum = op(Op::sin_, sum) + number(sum, i);
    const RegionUse f = m.end_region(std::array{sum.id});
    const std::array types{Type::float_};
    const Id s = m.begin_region(RegionKind::loop, "", types)[0];
    Value state{&m, s};
    for (int i = 0; i < shorter; ++i)
        state = op(Op::cos_, state) + number(state, i);
    const std::array results{op(Op::lt_, {&m, s}, number(state, 1)).id, state.id};
    const Id u = m.swizzle(m.input(SurfaceInput::uv0_), "x");
    const Id start = m.apply(f, std::array{u})[0];
    const Id last = m.apply(m.end_region(results, 3), std::array{start})[0];
    m.outputs = {{"height", WR_PORT_height, last}};
    const Id written = m.size();
    ForwardDiff direction = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0));
    const Id change = direction.jvp(last);
    EXPECT_NE(change, poison);
    EXPECT_LT(m.size() - written, 8u * shorter);
    m.outputs.push_back({"change", WR_PORT_float, change});
    EXPECT_EQ(verify(m), "");
    EXPECT_EQ(verify(expand(m, {.parameters = Parameters::baked})), "");
}

// Consecutive loops that read each other's results: each is differentiated once.
void loops_after_loops() {
    Module m;
    const std::array types{Type::float_};
    Id last = m.swizzle(m.input(SurfaceInput::uv0_), "x");
    for (int i = 0; i < 200; ++i) {
        const Value s{&m, m.begin_region(RegionKind::loop, "", types)[0]};
        const Value captured{&m, last};
        const std::array results{op(Op::lt_, s, captured).id, (s * captured + number(s, i)).id};
        last = m.apply(m.end_region(results, 3), std::array{last})[0];
    }
    const Id written = m.size();
    const Id change = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0)).jvp(last);
    EXPECT_NE(change, poison);
    EXPECT_LT(m.size() - written, 200u * 40);
    m.outputs = {{"change", WR_PORT_float, change}};
    EXPECT_EQ(verify(m), "");
}

TEST(Chain, OfLoopsThatReadEachOther) {
    on_small_stack(loops_after_loops);
}

// Functions that call functions, up to the maximum call depth and beyond.
void functions_in_functions(int count) {
    Module m;
    RegionUse below;
    const std::array types{Type::float_};
    for (int i = 0; i < count; ++i) {
        const Value x{&m, m.begin_region(RegionKind::function, "f", types)[0]};
        const Value inner = i == 0 ? x : Value{&m, m.apply(below, std::array{x.id})[0]};
        below = m.end_region(std::array{op(Op::sin_, inner * (i + 1.0)).id});
        if (!below.region) break;
    }
    EXPECT_EQ(m.problems.empty(), count <= Module::max_call + 1);
    if (!m.problems.empty()) return;
    const Id u = m.swizzle(m.input(SurfaceInput::uv0_), "x");
    const Id value = m.apply(below, std::array{u})[0];
    const Id change = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0)).jvp(value);
    m.outputs = {{"change", WR_PORT_float, change}};
    EXPECT_EQ(verify(m), "");
}

TEST(Chain, OfFunctionsThatCallEachOther) {
    // The derivative recurses over calls, up to that limit; sanitizers enlarge its stack frames
    // several times.
    constexpr size_t stack = 1024 * 1024;
    on_small_stack([] { functions_in_functions(Module::max_call); }, stack);
    on_small_stack([] { functions_in_functions(Module::max_call + 2); }, stack);
}

TEST(Chain, InRegions) {
    on_small_stack(chain_in_regions);
}

void layers() {
    Module m;
    Id sum = m.add(Op::gradient_zero_, {});
    const Value uv{&m, m.input(SurfaceInput::uv0_)};
    for (int i = 0; i < shorter; ++i) {
        const Value height = op(Op::sin_, uv.x() * static_cast<double>(i + 1));
        sum =
            m.add(Op::gradient_add_, {sum, m.add(Op::gradient_from_height_, {height.id}, poison)});
    }
    m.outputs = {{"normal", WR_PORT_normal, m.add(Op::resolve_, {sum}, 1)}};
    const Module expanded = expand(m, {});
    EXPECT_TRUE(expanded.problems.empty());
    EXPECT_EQ(verify(expanded), "");
    EXPECT_LT(expanded.size(), 20u * shorter);
}

TEST(Chain, LayersExpand) {
    on_small_stack(layers);
}

void calls() {
    Module m;
    const Id x = m.begin_region(RegionKind::function, "f", std::array{Type::float_})[0];
    const RegionUse f = m.end_region(std::array{m.add(Op::sin_, {x})});
    Id y = m.swizzle(m.input(SurfaceInput::uv0_), "x");
    for (int i = 0; i < shorter; ++i)
        y = m.apply(f, std::array{y})[0];
    m.outputs = {{"height", WR_PORT_height, y}};
    const Id written = m.size();
    ForwardDiff direction = direction_along(m, axis_of_uv(SurfaceInput::uv0_, 0));
    EXPECT_NE(direction.jvp(y), poison);
    EXPECT_LT(m.size() - written, 3u * shorter + 10);  // and the derived function
    EXPECT_EQ(verify(expand(m, {.parameters = Parameters::baked})), "");
}

TEST(Chain, OfCalls) {
    on_small_stack(calls);
}

// Heights added up: their slopes along two directions are packed.
void heights() {
    Module m;
    const Id uv = m.input(SurfaceInput::uv0_);
    Id a = m.swizzle(uv, "x"), b = m.swizzle(uv, "y");
    for (int i = 0; i < shorter; ++i) {
        a = m.add(Op::add_, {m.add(Op::sin_, {a}), m.number(i)});
        b = m.add(Op::add_, {m.add(Op::sin_, {b}), m.number(i)});
    }
    m.outputs = {{"o", WR_PORT_float, m.construct(Type::vec2_, {a, b})}};
    const Module packed = compact(m);
    EXPECT_EQ(verify(packed), "");
    EXPECT_LT(packed.size(), 8u * shorter);  // with the scalars, which are dead
}

TEST(Chain, OfPackedComponents) {
    on_small_stack(heights);
}

}  // namespace
}  // namespace wrinkle::test
