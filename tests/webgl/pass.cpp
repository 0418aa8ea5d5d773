#include "webgl/pass.h"

#include <cmath>

#include "image/stored.h"
#include "ir/op.h"

namespace wrinkle::test {
namespace {

// Every property of the sheet z = (x^2 - y^2) / 4 over [-1, 1]^2, and its differentials to the next
// pixel, named after the members.
constexpr const char* sheet = R"(
    const float step = 1.0 / 64.0;
    vec2 at = gl_FragCoord.xy * step;
    vec2 p = at * 2.0 - 1.0;
    vec3 position = vec3(p, 0.25 * (p.x * p.x - p.y * p.y));
    vec3 position_dx = vec3(1.0, 0.0, 0.5 * p.x) * (2.0 * step);
    vec3 position_dy = vec3(0.0, 1.0, -0.5 * p.y) * (2.0 * step);
    vec3 normal = vec3(-0.5 * p.x, 0.5 * p.y, 1.0);
    vec3 normal_dx = vec3(-step, 0.0, 0.0), normal_dy = vec3(0.0, step, 0.0);
    vec4 tangent = vec4(1.0, 0.0, 0.5 * p.x, 1.0);
    vec4 tangent_dx = vec4(0.0, 0.0, step, 0.0), tangent_dy = vec4(0.0);
    vec2 uv0 = at, uv0_dx = vec2(step, 0.0), uv0_dy = vec2(0.0, step);
    vec2 uv1 = vec2(at.y, -at.x) * 1.5, uv1_dx = vec2(0.0, -1.5 * step);
    vec2 uv1_dy = vec2(1.5 * step, 0.0);
    vec2 uv2 = at * 0.75, uv2_dx = uv0_dx * 0.75, uv2_dy = uv0_dy * 0.75;
    vec2 uv3 = at * 3.0, uv3_dx = uv0_dx * 3.0, uv3_dy = uv0_dy * 3.0;
    vec4 color0 = vec4(at, 0.5, 1.0);
    vec4 color0_dx = vec4(step, 0.0, 0.0, 0.0), color0_dy = vec4(0.0, step, 0.0, 0.0);
    vec3 to_eye = vec3(0.3, 0.2, 3.0) - position;
    vec3 view = normalize(to_eye);
    vec3 view_dx = (view * dot(view, position_dx) - position_dx) / length(to_eye);
    vec3 view_dy = (view * dot(view, position_dy) - position_dy) / length(to_eye);
    float facing = 1.0;
)";

std::string widened(const std::string& call, Type type) {
    switch (info(type).lanes) {
        case 1:
            return "vec3(" + call + ")";
        case 2:
            return "vec3(" + call + ", 0.0)";
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
    const OutputInfo& shown = r.outputs[output];
    std::string text = std::string(find_target(r.target)->version) + "\n" + shader.source +
                       "out vec4 result;\nvoid main() {" + sheet;
    if (!r.struct_name.empty()) text += "    " + r.struct_name + " s;\n";
    for (const MemberInfo& member : r.members)
        text += "    s." + member.name + " = " + member.name + ";\n";
    const std::string value = output_text(r, shown, call_text(r, "s"));
    return text + "    result = vec4(0.5 + 0.5 * " + widened(value, shown.type) + ", 1.0);\n}\n";
}

const MipChain& pass_picture() {
    static const MipChain picture = make_picture();
    return picture;
}

}  // namespace wrinkle::test
