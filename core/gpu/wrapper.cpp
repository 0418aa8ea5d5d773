#include "gpu/wrapper.h"

#include <array>

#include "emit/attributes.h"
#include "gpu/display.h"
#include "gpu/surface_values.h"
#include "wrinkle/plugin.h"

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
)";

constexpr std::string_view value_globals = R"(out vec4 WrView_color;
uniform bool WrView_raw;
uniform vec2 WrView_height_range;

vec3 WrView_gray(float height) {
    return vec3((height - WrView_height_range.x) / (WrView_height_range.y - WrView_height_range.x));
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

// By View, from `normal` on. In the gradient view, the normal may be on the invisible side of the
// surface: a graph may leave back faces unflipped.
constexpr std::array<ViewText, 6> view_texts{{
    {"", R"(    vec3 value = WrView_bumped;
    vec3 shown = 0.5 + 0.5 * value;
)"},
    {"", R"(    vec3 side = dot(WrView_bumped, surface) < 0.0 ? -surface : surface;
    vec3 value = side - WrView_bumped / dot(side, WrView_bumped);
    vec3 shown = 0.5 + 0.5 * value;
)"},
    {"", R"(    vec3 value = vec3(WrView_height);
    vec3 shown = WrView_gray(WrView_height);
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
constexpr std::array<OutputValue, 2> output_values{{
    {"vec3", "bumped", "normal", "surface"},
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

std::string assign(std::string_view type, std::string_view name, const std::string& value) {
    return std::string("    ").append(type).append(" WrView_").append(name) + " = " + value + ";\n";
}

// Statements that set `value` and `shown` to an output.
std::string show_output(const Shader& material, const OutputInfo& output) {
    const std::string text = output_text(material.reflection, output, "WrView_m");
    const std::string value = output.type == Type::vec2_   ? "vec3(" + text + ", 0.0)"
                              : output.type == Type::vec4_ ? text + ".xyz"
                                                           : "vec3(" + text + ")";
    const char* shown = "0.5 + 0.5 * value";
    if (is_height(output))
        shown = "WrView_gray(value.x)";
    else if (output.port_type == WR_PORT_color)
        shown = "WrView_encode(value)";
    else if (output.type == Type::float_)
        shown = "value";
    return "    vec3 value = " + value + ";\n    vec3 shown = " + shown + ";\n";
}

std::string show(const Shader& material, const ViewRequest& request, std::string_view body) {
    if (request.view == View::output) return show_output(material, *request.output);
    std::string text;
    for (const auto& [type, name, output, missing] : output_values) {
        if (body.find("WrView_" + std::string(name)) == body.npos) continue;
        const std::string found = output_expression(material, output, type);
        text += assign(type, name, found.empty() ? std::string(missing) : found);
    }
    const std::string flat = "dot(WrView_bumped, surface) < 0.0 ? -surface : surface";
    if (request.view == View::difference)
        text += assign(
            "vec3", "other",
            request.against ? output_expression(material, request.against->output, "vec3") : flat);
    return text.append(body);
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

bool is_height(const OutputInfo& output) {
    return output.port_type == WR_PORT_height;
}

ShaderText wrap_material(const Shader& material, const ViewRequest& request) {
    const std::string source = "#line 1\n" + material.source + "\n#line 100001\n";
    const std::string begin =
        "\nvoid main() {\n" + call(material.reflection) + std::string(surface_text);
    ShaderText text{vertex_text(), fragment_inputs() + source, {}};
    if (request.view == View::shaded) {
        const SurfaceModel model = surface_model(material);
        text.fragment += surface_outputs(model) + begin + pack_surface(material, model) + "}\n";
        for (int i = 0; i < surface_texels(model); ++i)
            text.outputs.push_back("WrView_texel" + std::to_string(i));
        return text;
    }
    const bool any = request.view == View::output;
    const ViewText view =
        any ? ViewText{encode_text(), ""} : view_texts[static_cast<size_t>(request.view) - 1];
    text.fragment += std::string(value_globals).append(view.declarations) + begin;
    text.fragment += show(material, request, view.body);
    text.fragment +=
        "    WrView_color = vec4(WrView_raw ? value : clamp(shown, 0.0, 1.0), 1.0);\n}\n";
    text.outputs.emplace_back("WrView_color");
    return text;
}

const OutputInfo* find_output(const Shader& material, const std::string& output) {
    for (const OutputInfo& each : material.reflection.outputs)
        if (each.output == output) return &each;
    return nullptr;
}

}  // namespace wrinkle::gpu
