// Tests of emitted expressions: the returned expression of one output.
#include "emit/expression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "emit/literal.h"
#include "glslang/validate.h"
#include "graphs.h"

namespace wrinkle::test {
namespace {

class Expressions : public testing::Test {
protected:
    Module m;
    Id x = parameter(m, "x", 0.5);
    Id y = parameter(m, "y", 0.5);
    Id z = parameter(m, "z", 0.5);
    Id uv = m.input(SurfaceInput::uv0_);
    Id p = m.input(SurfaceInput::position_);

    static std::string literal_text(Type type, double value) {
        std::string text;
        append_literal(glsl(), text, type, value);
        return text;
    }

    // Lines of the function between its braces, without the prefix of global names.
    std::string body(Id value) {
        m.outputs.clear();
        output(m, "o", value);
        EmitOptions options;
        options.bare_result = true;
        options.name = "q";
        const Shader shader = emit(m, options);
        EXPECT_EQ(compile_errors(shader), "");
        const size_t from = shader.source.find(") {\n") + 4;
        std::string text = shader.source.substr(from, shader.source.rfind("}\n") - from);
        constexpr std::string_view prefix = "q_";
        for (size_t at = text.find(prefix); at != text.npos; at = text.find(prefix, at))
            text.erase(at, prefix.size());
        return text;
    }
    std::string returned(Id value) {
        const std::string text = body(value);
        EXPECT_EQ(text.find("    return "), 0u) << text;
        return text.substr(11, text.size() - 13);
    }
    Id i(Id f) { return m.add(Op::to_int_, {f}); }
    Id u(Id f) { return m.add(Op::to_uint_, {i(f)}); }
    Id f(Id any) { return m.add(Op::to_float_, {any}); }
    Id op(Op o, Id a) { return m.add(o, {a}); }
    Id op(Op o, Id a, Id b) { return m.add(o, {a, b}); }
    Id op(Op o, Id a, Id b, Id c) { return m.add(o, {a, b, c}); }
};

TEST_F(Expressions, have_the_fewest_parentheses) {
    EXPECT_EQ(returned(op(Op::add_, op(Op::mul_, x, y), z)), "x * y + z");
    EXPECT_EQ(returned(op(Op::mul_, op(Op::add_, x, y), z)), "(x + y) * z");
    EXPECT_EQ(returned(op(Op::sub_, x, op(Op::sub_, y, z))), "x - (y - z)");
    EXPECT_EQ(returned(op(Op::sub_, op(Op::sub_, x, y), z)), "x - y - z");
    EXPECT_EQ(returned(op(Op::div_, x, op(Op::mul_, y, z))), "x / (y * z)");
    EXPECT_EQ(returned(op(Op::neg_, op(Op::add_, x, y))), "-(x + y)");
    EXPECT_EQ(returned(op(Op::mul_, op(Op::neg_, x), y)), "-x * y");
    EXPECT_EQ(returned(op(Op::mul_, x, m.number(-2))), "x * -2.0");
    EXPECT_EQ(returned(op(Op::max_, op(Op::add_, x, y), z)), "max(x + y, z)");
    EXPECT_EQ(returned(m.swizzle(op(Op::mul_, p, x), "z")), "(s.position * x).z");
}

TEST_F(Expressions, choose_with_the_conditional_operator) {
    const Id test = op(Op::lt_, x, y);
    EXPECT_EQ(returned(op(Op::select_, test, x, z)), "x < y ? x : z");
    EXPECT_EQ(returned(op(Op::add_, op(Op::select_, test, x, z), y)), "(x < y ? x : z) + y");
    EXPECT_EQ(returned(op(Op::select_, test, z, op(Op::select_, op(Op::gt_, z, y), x, y))),
              "x < y ? z : (z > y ? x : y)");
    EXPECT_EQ(returned(op(Op::sign_nonzero_, op(Op::sub_, x, y))), "x - y < 0.0 ? -1.0 : 1.0");
    const Id both = op(Op::and_, test, op(Op::or_, op(Op::ge_, y, z), op(Op::le_, x, z)));
    EXPECT_EQ(returned(op(Op::select_, op(Op::not_, both), x, y)),
              "!(x < y && (y >= z || x <= z)) ? x : y");
}

TEST_F(Expressions, of_whole_numbers) {
    const Id mixed = op(Op::bit_xor_, u(x), op(Op::shift_right_, u(y), m.literal(Type::uint_, 7)));
    EXPECT_EQ(returned(f(mixed)), "float(uint(int(x)) ^ (uint(int(y)) >> 7u))");
    const Id added = op(Op::bit_and_, op(Op::add_, i(x), i(y)), m.literal(Type::int_, 3));
    EXPECT_EQ(returned(f(added)), "float((int(x) + int(y)) & 3)");
    EXPECT_EQ(returned(f(op(Op::mul_, u(x), m.literal(Type::uint_, 4294967295.0)))),
              "float(uint(int(x)) * 4294967295u)");
    EXPECT_EQ(returned(f(op(Op::max_, i(x), m.literal(Type::int_, -2147483648.0)))),
              "float(max(int(x), (-2147483647 - 1)))");
    EXPECT_EQ(returned(f(op(Op::eq_, i(x), i(y)))), "float(int(x) == int(y))");
}

TEST_F(Expressions, widen_floats_where_a_built_in_wants_vectors) {
    EXPECT_EQ(returned(op(Op::mod_, uv, x)), "mod(s.uv0, x)");
    EXPECT_EQ(returned(op(Op::mod_, x, uv)), "mod(vec2(x), s.uv0)");
    EXPECT_EQ(returned(op(Op::max_, x, uv)), "max(vec2(x), s.uv0)");
    EXPECT_EQ(returned(op(Op::clamp_, uv, x, y)), "clamp(s.uv0, x, y)");
    EXPECT_EQ(returned(op(Op::clamp_, uv, x, uv)), "clamp(s.uv0, vec2(x), s.uv0)");
    EXPECT_EQ(returned(op(Op::mix_, uv, m.swizzle(uv, "yx"), x)), "mix(s.uv0, s.uv0.yx, x)");
    EXPECT_EQ(returned(op(Op::mix_, uv, x, y)), "mix(s.uv0, vec2(x), y)");
    EXPECT_EQ(returned(op(Op::step_, x, uv)), "step(x, s.uv0)");
    EXPECT_EQ(returned(op(Op::step_, uv, x)), "step(s.uv0, vec2(x))");
    EXPECT_EQ(returned(op(Op::smoothstep_, x, y, uv)), "smoothstep(x, y, s.uv0)");
    EXPECT_EQ(returned(op(Op::smoothstep_, x, uv, uv)), "smoothstep(vec2(x), s.uv0, s.uv0)");
    EXPECT_EQ(returned(op(Op::pow_, uv, x)), "pow(s.uv0, vec2(x))");
    EXPECT_EQ(returned(op(Op::atan2_, uv, x)), "atan(s.uv0, vec2(x))");
}

TEST_F(Expressions, of_vectors_and_matrices) {
    EXPECT_EQ(returned(m.construct(Type::vec3_, {x, x, x})), "vec3(x)");
    EXPECT_EQ(returned(m.construct(Type::vec3_, {uv, x})), "vec3(s.uv0, x)");
    const Id one = m.constant(Type::vec3_, std::array{1.0, 1.0, 1.0});
    EXPECT_EQ(returned(op(Op::sub_, p, one)), "s.position - 1.0");
    EXPECT_EQ(returned(op(Op::cross_, p, one)), "cross(s.position, vec3(1.0))");
    const Id matrix = m.construct(Type::mat3_, {p, m.input(SurfaceInput::normal_), one});
    EXPECT_EQ(returned(op(Op::transform_, matrix, p)),
              "mat3(s.position, s.normal, vec3(1.0)) * s.position");
    EXPECT_EQ(returned(m.add(Op::column_, {op(Op::transpose_, matrix)}, 1)),
              "transpose(mat3(s.position, s.normal, vec3(1.0)))[1]");
    EXPECT_EQ(body(op(Op::add_, m.construct(Type::vec3_, {x, x, x}), one)),
              "    return vec3(x) + 1.0;\n");
}

TEST_F(Expressions, spell_every_number) {
    EXPECT_EQ(literal_text(Type::float_, 1), "1.0");
    EXPECT_EQ(literal_text(Type::float_, 0.1), "0.1");
    EXPECT_EQ(literal_text(Type::float_, 9999), "9999.0");
    EXPECT_EQ(literal_text(Type::float_, 10000), "10000.0");
    EXPECT_EQ(literal_text(Type::float_, 100000), "1e+05");
    EXPECT_EQ(literal_text(Type::float_, 0.0), "0.0");
    EXPECT_EQ(literal_text(Type::int_, -3), "-3");
    EXPECT_EQ(literal_text(Type::float_, -0.0), "-0.0");
    EXPECT_EQ(literal_text(Type::float_, 1e-7), "1e-07");
    EXPECT_EQ(literal_text(Type::float_, 1e30), "1e+30");
    EXPECT_EQ(literal_text(Type::bool_, 1), "true");
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {infinity, -infinity, 1e300, std::nan(""), 1e-45, 3.4e38, -1e-7})
        EXPECT_NE(body(op(Op::max_, x, m.number(value))), "");
}

TEST_F(Expressions, do_not_skip_implicit_derivatives) {
    const Id texel = m.swizzle(image(m, "image", "a.png", uv), "x");
    const std::string text = body(op(Op::select_, op(Op::lt_, x, y), texel, z));
    EXPECT_EQ(text,
              "    vec4 texel = texture(image, s.uv0);\n"
              "    return x < y ? texel.x : z;\n");
    const Id change = m.swizzle(m.input(SurfaceInput::uv0_, Variant::dx), "y");
    EXPECT_EQ(body(op(Op::select_, op(Op::lt_, x, y), z, op(Op::add_, change, x))),
              "    float sum = dFdx(s.uv0).y + x;\n"
              "    return x < y ? z : sum;\n");
}

TEST_F(Expressions, sample_in_every_way) {
    const Id lod = m.add(Op::sample_lod_, {uv, x}, m[image(m, "image", "a.png", uv)].extra);
    EXPECT_EQ(returned(lod), "textureLod(image, s.uv0, x)");
    const Id grad = m.add(Op::sample_grad_, {uv, m.swizzle(uv, "yx"), uv}, m[lod].extra);
    EXPECT_EQ(returned(grad), "textureGrad(image, s.uv0, s.uv0.yx, s.uv0)");
    EXPECT_EQ(returned(m.add(Op::image_size_, {}, m[lod].extra)), "vec2(textureSize(image, 0))");
}

TEST_F(Expressions, leave_detach_out) {
    EXPECT_EQ(returned(op(Op::add_, op(Op::detach_, op(Op::mul_, x, y)), z)), "x * y + z");
}

TEST_F(Expressions, wide_ones_are_split) {
    Id sum = x;
    for (int k = 0; k < 40; ++k)
        sum = op(Op::add_, op(Op::sin_, op(Op::mul_, sum, m.number(1.5 + k))), y);
    const std::string text = body(sum);
    for (size_t from = 0; from < text.size();) {
        const size_t to = text.find('\n', from);
        EXPECT_LE(to - from, 100u);
        from = to + 1;
    }
    EXPECT_GT(std::count(text.begin(), text.end(), '\n'), 5);
}

}  // namespace
}  // namespace wrinkle::test
