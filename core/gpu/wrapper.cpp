#include "gpu/wrapper.h"

#include <array>

#include "base/standard_outputs.h"
#include "base/text.h"
#include "emit/attributes.h"

namespace wrinkle::gpu {
namespace {

constexpr std::string_view vertex_globals = R"(out vec3 WrView_position_relative;
out vec3 WrView_to_eye;
uniform mat4 WrView_to_clip;
uniform vec3 WrView_eye;

void main() {
)";

constexpr std::string_view vertex_end =
    R"(    WrView_position_relative = WrView_in_position - WrView_eye;
    WrView_to_eye = WrView_eye - WrView_in_drawn;
    gl_Position = WrView_to_clip * vec4(WrView_in_drawn, 1.0);
}
)";

constexpr std::string_view fragment_globals = R"(in vec3 WrView_position_relative;
in vec3 WrView_to_eye;
out vec4 WrView_color;
uniform bool WrView_raw;
)";

// Uniforms for the linear radiance of a point under one directional light and an environment.
// Directions are in world space. WrView_light is irradiance over pi, so a white diffuse surface
// that faces the light reflects WrView_light.
constexpr std::string_view shading_text = R"(
uniform mat3 WrView_normal_to_world;
uniform mat3 WrView_vector_to_world;
uniform vec3 WrView_to_light;
uniform float WrView_light;
uniform float WrView_environment;
)";

constexpr std::string_view curve_text = R"(
uniform float WrView_exposure;

vec3 WrView_display(vec3 radiance) {
    vec3 c = max(radiance * WrView_exposure, 0.0);
    vec3 beyond = max(c - 0.8, 0.0);
    c = min(c, 0.8) + 0.2 * beyond / (beyond + 0.2);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
)";

constexpr std::string_view sky_text = R"(
vec3 WrView_sky(float height, float blur) {
    return mix(vec3(0.07, 0.065, 0.06), vec3(0.30, 0.33, 0.38), smoothstep(-blur, blur, height));
}

vec3 WrView_irradiance(vec3 n) {
    return WrView_sky(n.y, 1.2);
}

vec3 WrView_mirrored(vec3 direction, float roughness) {
    return WrView_sky(direction.y, mix(0.1, 1.2, roughness));
}
)";

constexpr std::string_view surroundings_text = R"(
uniform samplerCube WrView_surroundings;
uniform vec2 WrView_environment_turn;  // cosine and sine

vec3 WrView_around(vec3 direction, float level) {
    float c = WrView_environment_turn.x, s = WrView_environment_turn.y;
    vec3 turned = vec3(c * direction.x - s * direction.z, direction.y,
                       s * direction.x + c * direction.z);
    return textureLod(WrView_surroundings, turned, level).rgb;
}

vec3 WrView_irradiance(vec3 n) {
    return WrView_around(n, 5.0);
}

vec3 WrView_mirrored(vec3 direction, float roughness) {
    return WrView_around(direction, 4.0 * roughness);
}
)";

constexpr std::string_view ggx_text = R"(
vec3 WrView_shade(vec3 n, vec3 v, vec3 base, float roughness, float metalness, float occlusion) {
    vec3 f0 = mix(vec3(0.04), base, metalness);
    vec3 diffuse = base * (1.0 - metalness);
    float a2 = pow(max(roughness, 0.05), 4.0);
    vec3 h = normalize(WrView_to_light + v);
    float nv = max(dot(n, v), 1e-3);
    float nl = max(dot(n, WrView_to_light), 0.0);
    float nh = max(dot(n, h), 0.0);
    float facet = nh * nh * (a2 - 1.0) + 1.0;
    float distribution = a2 / (facet * facet);
    float visibility = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2)
                              + nv * sqrt(nl * nl * (1.0 - a2) + a2));
    vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - max(dot(v, h), 0.0), 5.0);
    vec3 direct = (diffuse + fresnel * distribution * visibility) * WrView_light * nl;
    vec3 edge = max(vec3(1.0 - roughness), f0);
    vec3 reflected = f0 + (edge - f0) * pow(1.0 - nv, 5.0);
    vec3 around = diffuse * WrView_irradiance(n)
                  + reflected * WrView_mirrored(reflect(-v, n), roughness);
    return direct + around * occlusion * WrView_environment;
}
)";

constexpr std::string_view phong_text = R"(
uniform vec4 WrView_phong;  // Ka, Kd, Ks, shininess

vec3 WrView_shade(vec3 n, vec3 v, vec3 base, float roughness, float metalness, float occlusion) {
    float nl = max(dot(n, WrView_to_light), 0.0);
    float rv = max(dot(reflect(-WrView_to_light, n), v), 0.0);
    float highlight = nl > 0.0 && rv > 0.0 ? pow(rv, WrView_phong.w) : 0.0;
    return base * (WrView_phong.x + WrView_phong.y * nl) + WrView_phong.z * highlight;
}
)";

constexpr std::string_view difference_text = R"(
uniform float WrView_heat_degrees;

float WrView_angle(vec3 a, vec3 b) {
    return degrees(atan(length(cross(a, b)), dot(a, b)));
}

vec3 WrView_heat(float angle) {
    const vec3 colors[10] = vec3[10](
        vec3(0, 34, 78), vec3(18, 53, 112), vec3(59, 73, 108), vec3(87, 93, 109),
        vec3(112, 113, 115), vec3(138, 134, 120), vec3(165, 156, 116), vec3(195, 179, 105),
        vec3(225, 204, 85), vec3(254, 232, 56));
    float t = 9.0 * clamp(angle / WrView_heat_degrees, 0.0, 1.0);
    int step = min(int(t), 8);
    return mix(colors[step], colors[step + 1], t - float(step)) / 255.0;
}
)";

// GLSL of a view: declarations, and statements of main() that set `value` and `shown`.
struct ViewText {
    std::string_view declarations, body;
};

// By View; shading_of() has the declarations of the shaded view. In the gradient view, the normal
// may be on the invisible side of the surface: a graph may leave back faces unflipped.
constexpr std::array<ViewText, 7> view_texts{{
    {"", R"(    vec3 n = normalize(WrView_normal_to_world * WrView_bumped);
    vec3 v = normalize(WrView_vector_to_world * WrView_to_eye);
    vec3 value = WrView_shade(n, v, WrView_base, clamp(WrView_roughness, 0.0, 1.0),
                              clamp(WrView_metalness, 0.0, 1.0), WrView_occlusion)
                 + WrView_emission;
    vec3 shown = WrView_display(value);
)"},
    {"", R"(    vec3 value = WrView_bumped;
    vec3 shown = 0.5 + 0.5 * value;
)"},
    {"", R"(    vec3 side = dot(WrView_bumped, surface) < 0.0 ? -surface : surface;
    vec3 value = side - WrView_bumped / dot(side, WrView_bumped);
    vec3 shown = 0.5 + 0.5 * value;
)"},
    {"uniform vec2 WrView_height_range;\n", R"(    vec3 value = vec3(WrView_height);
    vec3 shown = (value - WrView_height_range.x) / (WrView_height_range.y - WrView_height_range.x);
)"},
    {"", R"(    vec3 value = vec3(WrView_uv0, 0.0);
    vec3 shown = fract(value);
)"},
    {difference_text, R"(    float angle = WrView_angle(WrView_bumped, WrView_other);
    vec3 value = vec3(angle);
    vec3 shown = WrView_heat(angle);
)"},
    {"uniform float WrView_edges;\n", R"(    vec3 to_eye = normalize(WrView_to_eye);
    vec3 value = vec3(WrView_edges);
    vec3 shown = mix(vec3(0.12 + 0.2 * abs(dot(surface, to_eye))), vec3(0.75), WrView_edges);
)"},
}};

// A variable of main() with the value of an output, for the views that read it.
struct OutputValue {
    std::string_view type, name, output, missing;
};
constexpr std::array<OutputValue, 6> output_values{{
    {"vec3", "bumped", "normal", "surface"},
    {"vec3", "base", "color", "vec3(0.6)"},
    {"float", "roughness", "roughness", "0.5"},
    {"float", "metalness", "metalness", "0.0"},
    {"float", "occlusion", "occlusion", "1.0"},
    {"float", "height", "height", "0.0"},
}};

// `surface` is the unit surface normal, flipped towards the eye; materials without a normal output
// use it.
constexpr std::string_view surface_text = R"(    float WrView_length = length(WrView_normal);
    vec3 surface = WrView_length > 0.0 ? WrView_normal / WrView_length : vec3(0.0, 0.0, 1.0);
    surface = gl_FrontFacing ? surface : -surface;
)";

// Expression in main() for a member of the material's struct, in object space. Interpolated vectors
// are not normalised; `view` is towards the eye, `facing` is 1 on the side of the normal, else -1.
std::string member_value(const MemberInfo& member) {
    if (member.input == SurfaceInput::view_) return "normalize(WrView_to_eye)";
    if (member.input == SurfaceInput::facing_) return "(gl_FrontFacing ? 1.0 : -1.0)";
    return "WrView_" + std::string(info(member.input).name) + (member.relative ? "_relative" : "");
}

// Calls the function, if there is one: WrView_m is its result.
std::string call(const Reflection& reflection) {
    if (reflection.function.empty()) return {};
    std::string text;
    if (!reflection.struct_name.empty()) text = "    " + reflection.struct_name + " WrView_s;\n";
    for (const MemberInfo& member : reflection.members)
        text += "    WrView_s." + member.name + " = " + member_value(member) + ";\n";
    return text + "    " + result_type(reflection) +
           " WrView_m = " + call_text(reflection, "WrView_s") + ";\n";
}

std::string value_of(const Shader& material, const OutputInfo& output) {
    return output_text(material.reflection, output, "WrView_m");
}

std::string assign(std::string_view type, std::string_view name, const std::string& value) {
    return std::string("    ").append(type).append(" WrView_").append(name) + " = " + value + ";\n";
}

// Emission is added to the lit color, in units of `nits_of_unit_emission`.
std::string emission_of(const Shader& material) {
    const OutputInfo* color = find_output(material, "emission");
    const OutputInfo* luminance = find_output(material, "emission_luminance");
    if (!color && !luminance) return "vec3(0.0)";
    std::string value = color ? value_of(material, *color) : "vec3(1.0)";
    if (luminance)
        value += " * (" + value_of(material, *luminance) + " * " +
                 shortest(1 / nits_of_unit_emission) + ")";
    return "max(" + value + ", 0.0)";
}

std::string values_of(const Shader& material, View view, const OutputInfo* against) {
    const std::string_view body = view_texts[static_cast<size_t>(view)].body;
    std::string text;
    for (const auto& [type, name, output, missing] : output_values) {
        if (body.find("WrView_" + std::string(name)) == body.npos) continue;
        const OutputInfo* found = find_output(material, std::string(output));
        text += assign(type, name,
                       found ? std::string(type) + "(" + value_of(material, *found) + ")"
                             : std::string(missing));
    }
    if (view == View::shaded) text += assign("vec3", "emission", emission_of(material));
    const std::string flat = "dot(WrView_bumped, surface) < 0.0 ? -surface : surface";
    if (view == View::difference)
        text +=
            assign("vec3", "other", against ? "vec3(" + value_of(material, *against) + ")" : flat);
    return text;
}

std::string shading_of(const Shading& shading) {
    std::string text = std::string(shading_text).append(curve_text);
    if (shading.lighting == Lighting::phong) return text.append(phong_text);
    return text.append(shading.environment ? surroundings_text : sky_text).append(ggx_text);
}

// Calls use(input, type, name) for each input with a vertex attribute.
template <typename Use>
void each_attribute(Use use) {
    for (int i = 0; i < surface_input_count; ++i) {
        const auto input = static_cast<SurfaceInput>(i);
        if (location_of(input) < 0) continue;
        const SurfaceInfo& property = info(input);
        use(input, std::string(info(property.type).name), std::string(property.name));
    }
}

std::string attribute_text(int location, const std::string& type, const std::string& name) {
    return "layout(location = " + std::to_string(location) + ") in " + type + " WrView_in_" + name +
           ";\n";
}

std::string vertex_text() {
    std::string text = "#version 330 core\n" + attribute_text(drawn_location, "vec3", "drawn");
    std::string copies;
    each_attribute([&](SurfaceInput input, const std::string& type, const std::string& name) {
        text += attribute_text(location_of(input), type, name);
        text += "out " + type + " WrView_" + name + ";\n";
        copies += "    WrView_" + name + " = WrView_in_" + name + ";\n";
    });
    return text.append(vertex_globals).append(copies).append(vertex_end);
}

std::string fragment_inputs() {
    std::string text = "#version 330 core\n";
    each_attribute([&](SurfaceInput, const std::string& type, const std::string& name) {
        text += "in " + type + " WrView_" + name + ";\n";
    });
    return text.append(fragment_globals);
}

}  // namespace

std::string_view display_text() {
    return curve_text;
}

ShaderText wrap_material(const Shader& material, View view, const OutputInfo* against,
                         const Shading& shading) {
    const ViewText& texts = view_texts[static_cast<size_t>(view)];
    std::string fragment = fragment_inputs();
    fragment += "#line 1\n" + material.source + "\n#line 100001\n";
    fragment += view == View::shaded ? shading_of(shading) : std::string(texts.declarations);
    fragment += "\nvoid main() {\n";
    fragment += call(material.reflection);
    fragment += surface_text;
    fragment += values_of(material, view, against);
    fragment += texts.body;
    fragment += "    WrView_color = vec4(WrView_raw ? value : clamp(shown, 0.0, 1.0), 1.0);\n}\n";
    return {vertex_text(), std::move(fragment)};
}

const OutputInfo* find_output(const Shader& material, const std::string& output) {
    for (const OutputInfo& each : material.reflection.outputs)
        if (each.output == output) return &each;
    return nullptr;
}

}  // namespace wrinkle::gpu
