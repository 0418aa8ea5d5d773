#include "hosts/pass.h"

#include <cmath>

#include "emit/language.h"
#include "image/stored.h"
#include "ir/op.h"

namespace wrinkle::test {
namespace {

struct Property {
    Type type;
    const char* name;
    const char* value;  // in GLSL and WGSL
};

// Every property of the sheet z = (x^2 - y^2) / 4 over [-1, 1]^2 and its differentials to the next
// pixel, named after the members. `at` is the pixel's center in [0, 1]^2.
constexpr Property sheet[] = {
    {Type::vec2_, "p", "at * 2.0 - 1.0"},
    {Type::vec3_, "position", "vec3(p, 0.25 * (p.x * p.x - p.y * p.y))"},
    {Type::vec3_, "position_dx", "vec3(1.0, 0.0, 0.5 * p.x) * (2.0 * width)"},
    {Type::vec3_, "position_dy", "vec3(0.0, 1.0, -0.5 * p.y) * (2.0 * width)"},
    {Type::vec3_, "normal", "vec3(-0.5 * p.x, 0.5 * p.y, 1.0)"},
    {Type::vec3_, "normal_dx", "vec3(-width, 0.0, 0.0)"},
    {Type::vec3_, "normal_dy", "vec3(0.0, width, 0.0)"},
    {Type::vec4_, "tangent", "vec4(1.0, 0.0, 0.5 * p.x, 1.0)"},
    {Type::vec4_, "tangent_dx", "vec4(0.0, 0.0, width, 0.0)"},
    {Type::vec4_, "tangent_dy", "vec4(0.0, 0.0, 0.0, 0.0)"},
    {Type::vec2_, "uv0", "at"},
    {Type::vec2_, "uv0_dx", "vec2(width, 0.0)"},
    {Type::vec2_, "uv0_dy", "vec2(0.0, width)"},
    {Type::vec2_, "uv1", "vec2(at.y, -at.x) * 1.5"},
    {Type::vec2_, "uv1_dx", "vec2(0.0, -1.5 * width)"},
    {Type::vec2_, "uv1_dy", "vec2(1.5 * width, 0.0)"},
    {Type::vec2_, "uv2", "at * 0.75"},
    {Type::vec2_, "uv2_dx", "uv0_dx * 0.75"},
    {Type::vec2_, "uv2_dy", "uv0_dy * 0.75"},
    {Type::vec2_, "uv3", "at * 3.0"},
    {Type::vec2_, "uv3_dx", "uv0_dx * 3.0"},
    {Type::vec2_, "uv3_dy", "uv0_dy * 3.0"},
    {Type::vec4_, "color0", "vec4(at, 0.5, 1.0)"},
    {Type::vec4_, "color0_dx", "vec4(width, 0.0, 0.0, 0.0)"},
    {Type::vec4_, "color0_dy", "vec4(0.0, width, 0.0, 0.0)"},
    {Type::vec3_, "to_eye", "vec3(0.3, 0.2, 3.0) - position"},
    {Type::vec3_, "view", "normalize(to_eye)"},
    {Type::vec3_, "view_dx", "(view * dot(view, position_dx) - position_dx) / length(to_eye)"},
    {Type::vec3_, "view_dy", "(view * dot(view, position_dy) - position_dy) / length(to_eye)"},
    {Type::float_, "facing", "1.0"}};

// Returns code that computes the sheet at `center`, that of a pixel, and the output shown as
// `shown`.
std::string pass_code(const Shader& shader, size_t output, const Language& language,
                      const char* center) {
    const Reflection& r = shader.reflection;
    std::string text;
    const auto add = [&](Type type, std::string_view name, std::string_view value) {
        text += "    " +
                filled(language.constant, {{'t', language.type(type)}, {'n', name}, {'v', value}}) +
                "\n";
    };
    add(Type::float_, "width", "1.0 / 64.0");
    add(Type::vec2_, "at", std::string(center) + ".xy * width");
    for (const Property& property : sheet)
        add(property.type, property.name, property.value);
    const OutputInfo& wanted = r.outputs[output];
    if (r.result_form == ResultForm::parameters) {
        std::string arguments;
        for (const MemberInfo& member : r.members)
            arguments += (arguments.empty() ? "" : ", ") + member.name;
        for (const OutputInfo& each : r.outputs) {
            text += "    " + std::string(language.type(each.type)) + " " + each.member + ";\n";
            arguments += (arguments.empty() ? "" : ", ") + each.member;
        }
        text += "    " + r.function + "(" + arguments + ");\n";
        add(wanted.type, "shown", wanted.member);
        return text;
    }
    if (!r.struct_name.empty())
        text += "    " + filled(language.unset, {{'t', r.struct_name}, {'n', "s"}}) + "\n";
    for (const MemberInfo& member : r.members)
        text += "    s." + member.name + " = " + member.name + ";\n";
    add(wanted.type, "shown", output_text(r, wanted, call_text(r, "s")));
    return text;
}

std::string widened(const std::string& call, Type type, std::string_view vec3 = "vec3") {
    switch (info(type).lanes) {
        case 1:
            return std::string(vec3) + "(" + call + ")";
        case 2:
            return std::string(vec3) + "(" + call + ", 0.0)";
        case 3:
            return call;
        default:
            return "(" + call + ").xyz";
    }
}

float in_half(double value) {
    return float_from_half(half_from_float(static_cast<float>(value)));
}

MipChain make_picture() {
    constexpr uint32_t size = 64;
    constexpr double turn = 6.283185307179586 / size;
    Image image;
    image.width = image.height = size;
    image.channels = 4;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x)
            for (const double value :
                 {0.5 + 0.2 * std::sin(turn * 3 * x), 0.5 + 0.2 * std::cos(turn * 2 * (x + y)),
                  0.875 + 0.1 * std::sin(turn * y), 1.0})
                image.data.push_back(static_cast<float>(value));
    MipChain chain = build_mips(std::move(image));
    for (Image& level : chain.levels)
        for (float& value : level.data)
            value = in_half(value);
    return chain;
}

}  // namespace

std::string pass_vertex(const Target& target) {
    return std::string(target.version) + R"(
void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
}
)";
}

std::string pass_fragment(const Shader& shader, size_t output) {
    const Reflection& r = shader.reflection;
    return std::string(find_target(r.target)->version) + "\n" + shader.source +
           "out vec4 result;\nvoid main() {\n" + pass_code(shader, output, glsl(), "gl_FragCoord") +
           "    result = vec4(0.5 + 0.5 * " + widened("shown", r.outputs[output].type) +
           ", 1.0);\n}\n";
}

std::string pass_module(const Shader& shader, size_t output) {
    return shader.source + R"(
@vertex fn pass_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(select(-1.0, 3.0, index == 1), select(-1.0, 3.0, index == 2), 0.0, 1.0);
}
@fragment fn pass_fragment(@builtin(position) place: vec4f) -> @location(0) vec4f {
)" + pass_code(shader, output, wgsl(), "place") +
           "    return vec4f(0.5 + 0.5 * " +
           widened("shown", shader.reflection.outputs[output].type, "vec3f") + ", 1.0);\n}\n";
}

std::string pass_canvas(const Shader& shader, size_t output) {
    return "shader_type canvas_item;\nrender_mode blend_disabled;\n" + shader.source +
           "void fragment() {\n" + pass_code(shader, output, godot3(), "(UV * 64.0)") +
           "    COLOR = vec4(0.5 + 0.5 * " +
           widened("shown", shader.reflection.outputs[output].type) + ", 1.0);\n}\n";
}

const MipChain& pass_picture() {
    static const MipChain picture = make_picture();
    return picture;
}

}  // namespace wrinkle::test
