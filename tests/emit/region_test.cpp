// Tests of functions and loops.
#include <gtest/gtest.h>

#include <algorithm>

#include "glslang/validate.h"
#include "golden.h"
#include "graphs.h"
#include "ir/inspect.h"

namespace wrinkle::test {
namespace {

std::string source(const Module& m) {
    EXPECT_EQ(verify(m), "");
    const Shader shader = emit(m, {});
    EXPECT_EQ(compile_errors(shader), "");
    return shader.source;
}

Id x_of(Module& m) {
    return m.swizzle(m.input(SurfaceInput::position_), "x");
}

TEST(Regions, functions_are_written_once_and_before_their_readers) {
    Module m;
    const uint32_t noise = node(m, "noise", "Noise");
    const std::array one{Type::float_};
    const auto a = m.begin_region(RegionKind::function, "inner", one);
    const Id inner_value = m.add(Op::sin_, {m.add(Op::mul_, {a[0], m.number(3)})});
    const RegionUse inner = m.end_region(std::array{inner_value});
    const auto b = m.begin_region(RegionKind::function, "outer", one);
    const Id twice = m.add(Op::add_, {m.apply(inner, b)[0], b[0]});
    const RegionUse outer =
        m.end_region(std::array{m.add(Op::mul_, {twice, parameter(m, "scale", 2)}), twice});
    const auto results = m.apply(outer, std::array{x_of(m)});
    const auto others = m.apply(outer, std::array{m.add(Op::neg_, {x_of(m)})});
    EXPECT_EQ(m.origin[results[0]], noise);
    output(m, "value", m.add(Op::sub_, {results[0], others[0]}));
    output(m, "second", results[1]);
    const std::string text = source(m);
    EXPECT_TRUE(equals_golden(text, "functions.glsl"));
    EXPECT_LT(text.find("wrinkle_material_inner(float a)"),
              text.find("wrinkle_material_outer(float a"));
}

TEST(Regions, a_loop_breaks_before_it_computes_the_next_state) {
    Module m;
    node(m, "march", "March");
    const Id far = m.add(Op::cos_, {x_of(m)});
    const auto state = m.begin_region(RegionKind::loop, "", std::array{Type::float_, Type::vec2_});
    const Id height =
        m.swizzle(m.add(Op::sample_lod_, {state[1], m.number(0)},
                        m[image(m, "height", "h.png", m.input(SurfaceInput::uv0_))].extra),
                  "x");
    const Id write_loop_condition = m.add(Op::lt_, {state[0], height});
    const Id next_depth = m.add(Op::add_, {state[0], m.add(Op::mul_, {far, m.number(0.1)})});
    const Id next_uv = m.add(Op::add_, {state[1], m.add(Op::mul_, {state[1], state[0]})});
    const RegionUse loop = m.end_region(std::array{write_loop_condition, next_depth, next_uv}, 32);
    const auto results = m.apply(loop, std::array{m.number(0), m.input(SurfaceInput::uv0_)});
    name(m, "depth", results[0]);
    name(m, "uv", results[1]);
    output(m, "depth", results[0]);
    output(m, "uv", m.add(Op::mul_, {results[1], m.number(2)}));
    const std::string text = source(m);
    EXPECT_TRUE(equals_golden(text, "loop.glsl"));
    const size_t stop = text.find("break;");
    EXPECT_LT(text.find("textureLod"), stop);
    EXPECT_GT(text.find("march_depth += "), stop);
}

TEST(Regions, a_loops_state_changes_at_once) {
    Module m;
    node(m, "swap", "Swap");
    const auto s = m.begin_region(RegionKind::loop, "", std::array{Type::float_, Type::float_});
    const Id write_loop_condition = m.literal(Type::bool_, 1);
    const RegionUse loop = m.end_region(std::array{write_loop_condition, s[1], s[0]}, 3);
    const auto results = m.apply(loop, std::array{x_of(m), m.number(7)});
    output(m, "o", m.add(Op::sub_, {results[0], results[1]}));
    const std::string text = source(m);
    EXPECT_NE(text.find("        float swap_state_next = swap_state_2;\n"
                        "        swap_state_2 = swap_state;\n"
                        "        swap_state = swap_state_next;\n"),
              std::string::npos)
        << text;
    EXPECT_EQ(text.find("break"), std::string::npos);
}

TEST(Regions, a_loops_state_that_is_a_literal_waits_for_no_other) {
    Module m;
    node(m, "reset", "Reset");
    const auto s = m.begin_region(RegionKind::loop, "", std::array{Type::float_, Type::float_});
    const Id write_loop_condition = m.add(Op::lt_, {s[0], s[1]});
    const Id next = m.add(Op::add_, {s[0], m.add(Op::sin_, {s[1]})});
    const RegionUse loop =
        m.end_region(std::array{write_loop_condition, next, m.number(0.123456789)}, 3);
    const auto results = m.apply(loop, std::array{x_of(m), m.add(Op::cos_, {x_of(m)})});
    output(m, "o", m.add(Op::sub_, {results[0], results[1]}));
    const std::string text = source(m);
    EXPECT_NE(text.find("        reset_state_2 = 0.12345679;\n"), std::string::npos) << text;
}

TEST(Regions, nested_loops_and_loops_in_functions) {
    Module m;
    node(m, "sum", "Sum");
    const std::array one{Type::float_};
    const auto p = m.begin_region(RegionKind::function, "spiral", one);
    const auto outer = m.begin_region(RegionKind::loop, "", one);
    const Id shared = m.add(Op::sin_, {outer[0]});
    const auto inner = m.begin_region(RegionKind::loop, "", one);
    const Id inner_next = m.add(Op::add_, {inner[0], m.add(Op::mul_, {shared, p[0]})});
    const RegionUse inner_loop =
        m.end_region(std::array{m.add(Op::lt_, {inner[0], shared}), inner_next}, 4);
    const Id result = m.apply(inner_loop, std::array{outer[0]})[0];
    const RegionUse outer_loop =
        m.end_region(std::array{m.add(Op::not_, {m.add(Op::gt_, {outer[0], p[0]})}), result}, 5);
    const Id end = m.apply(outer_loop, std::array{m.number(1)})[0];
    const RegionUse function = m.end_region(std::array{end});
    const Id first = m.apply(function, std::array{x_of(m)})[0];
    const Id second = m.apply(function, std::array{first})[0];
    output(m, "o", m.add(Op::add_, {first, second}));
    EXPECT_TRUE(equals_golden(source(m), "nested_loops.glsl"));
}

TEST(Regions, siblings_that_share_instructions) {
    Module m;
    node(m, "twice", "Twice");
    Id sum = m.number(0);
    for (const double limit : {2.0, 3.0}) {
        const auto s = m.begin_region(RegionKind::loop, "", std::array{Type::float_});
        const Id common = m.add(Op::sin_, {s[0]});
        const Id next = m.add(Op::add_, {m.add(Op::mul_, {common, common}), s[0]});
        const Id write_loop_condition = m.add(Op::lt_, {common, m.number(limit)});
        const RegionUse loop = m.end_region(std::array{write_loop_condition, next}, 8);
        sum = m.add(Op::add_, {sum, m.apply(loop, std::array{x_of(m)})[0]});
    }
    output(m, "o", sum);
    const std::string text = source(m);
    EXPECT_NE(text.find("sin(twice_state)"), std::string::npos) << text;
    EXPECT_NE(text.find("sin(twice_state_2)"), std::string::npos) << text;
}

TEST(Regions, what_a_loop_captures_stands_before_it) {
    Module m;
    node(m, "far", "Value");
    const Id outside = m.add(Op::tan_, {x_of(m)});
    const Id change = m.swizzle(m.input(SurfaceInput::uv0_, Variant::dx), "x");
    node(m, "loop", "Loop");
    const auto s = m.begin_region(RegionKind::loop, "", std::array{Type::float_});
    const Id next = m.add(Op::add_, {s[0], m.add(Op::mul_, {outside, change})});
    const RegionUse loop = m.end_region(std::array{m.add(Op::lt_, {s[0], m.number(9)}), next}, 8);
    output(m, "o", m.apply(loop, std::array{m.number(0)})[0]);
    const std::string text = source(m);
    EXPECT_LT(text.find("tan("), text.find("for ("));
    EXPECT_LT(text.find("dFdx("), text.find("for ("));
}

TEST(Regions, long_calls_go_on_on_the_next_line) {
    Module m;
    node(m, "a node with a long name", "Node");
    const std::vector<Type> types(12, Type::float_);
    const auto params = m.begin_region(RegionKind::function, "a_function_of_many", types);
    Id sum = params[0];
    for (size_t k = 1; k < params.size(); ++k)
        sum = m.add(Op::add_, {m.add(Op::mul_, {sum, sum}), params[k]});
    const RegionUse use = m.end_region(std::array{sum});
    std::vector<Id> args;
    for (size_t k = 0; k < types.size(); ++k)
        args.push_back(m.add(Op::sin_, {parameter(m, "amount", static_cast<double>(k))}));
    output(m, "o", m.apply(use, args)[0]);
    const Shader shader = emit(m, {});
    EXPECT_EQ(compile_errors(shader), "");
    EXPECT_EQ(static_cast<size_t>(std::count(shader.source.begin(), shader.source.end(), '\n')),
              shader.reflection.lines.size());
    for (size_t from = 0; from < shader.source.size();) {
        const size_t to = shader.source.find('\n', from);
        EXPECT_LE(to - from, 100u);
        from = to + 1;
    }
}

}  // namespace
}  // namespace wrinkle::test
