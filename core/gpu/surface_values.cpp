#include "gpu/surface_values.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/standard_outputs.h"
#include "base/text.h"
#include "gpu/wrapper.h"

namespace wrinkle::gpu {
namespace {

enum class Stored : uint8_t { number, color, direction, radiance };

struct SurfaceValue {
    std::string_view name;  // in WrView_Surface
    std::string_view output;
    Stored stored;
    double scale = 1;  // a number or a channel is stored as value / scale, clamped to [0, 1]
};

// Slots of 16 bits, in order; the plain model has the first `plain_values`.
constexpr size_t plain_values = 14;
constexpr std::array<SurfaceValue, 27> surface_values{{
    {"normal", "normal", Stored::direction},
    {"surface", "", Stored::direction},
    {"color", "color", Stored::color},
    {"opacity", "opacity", Stored::number},
    {"metalness", "metalness", Stored::number},
    {"roughness", "roughness", Stored::number},
    {"occlusion", "occlusion", Stored::number},
    {"diffuse_roughness", "base_diffuse_roughness", Stored::number},
    {"specular_weight", "specular_weight", Stored::number, 32},
    {"ior", "specular_ior", Stored::number, 8},
    {"tangent", "tangent", Stored::direction},
    {"emission", "emission", Stored::radiance},
    {"anisotropy", "specular_roughness_anisotropy", Stored::number},
    {"base_weight", "base_weight", Stored::number},
    {"specular_color", "specular_color", Stored::color},
    {"coat_weight", "coat_weight", Stored::number},
    {"coat_color", "coat_color", Stored::color},
    {"coat_roughness", "coat_roughness", Stored::number},
    {"coat_normal", "coat_normal", Stored::direction},
    {"coat_ior", "coat_ior", Stored::number, 8},
    {"coat_darkening", "coat_darkening", Stored::number},
    {"fuzz_color", "fuzz_color", Stored::color},
    {"fuzz_weight", "fuzz_weight", Stored::number},
    {"fuzz_roughness", "fuzz_roughness", Stored::number},
    {"subsurface_color", "subsurface_color", Stored::color},
    {"subsurface_weight", "subsurface_weight", Stored::number},
    {"subsurface_scale", "subsurface_radius_scale", Stored::color},
}};

constexpr size_t slots_of(Stored stored) {
    switch (stored) {
        case Stored::number:
            return 1;
        case Stored::direction:
            return 2;
        case Stored::color:
            return 3;
        case Stored::radiance:
            return 6;
    }
    return 0;
}

constexpr size_t values_of(SurfaceModel model) {
    return model == SurfaceModel::plain ? plain_values : surface_values.size();
}

constexpr size_t slots_of(SurfaceModel model) {
    size_t slots = 0;
    for (size_t i = 0; i < values_of(model); ++i)
        slots += slots_of(surface_values[i].stored);
    return slots;
}

constexpr size_t slots_per_texel = 8;
static_assert(slots_of(SurfaceModel::plain) == 3 * slots_per_texel);
static_assert(slots_of(SurfaceModel::layered) <= 6 * slots_per_texel);

constexpr std::string_view type_of(Stored stored) {
    return stored == Stored::number ? "float" : "vec3";
}

constexpr std::string_view pack_text = R"(
uint WrView_pair(float a, float b) {
    uvec2 bits = uvec2(clamp(vec2(a, b), 0.0, 1.0) * 65535.0 + 0.5);
    return bits.x | bits.y << 16u;
}

vec2 WrView_octahedral(vec3 d) {
    vec2 p = d.xy / max(abs(d.x) + abs(d.y) + abs(d.z), 1e-30);
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return 0.5 + 0.5 * (d.z < 0.0 ? (1.0 - abs(p.yx)) * side : p);
}
)";

constexpr std::string_view unpack_text = R"(
vec3 WrView_unit(float x, float y) {
    vec2 p = 2.0 * vec2(x, y) - 1.0;
    vec3 d = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    if (d.z < 0.0) d.xy = (1.0 - abs(p.yx)) * side;
    return normalize(d);
}
)";

// GLSL of the value where a material has no such output.
std::string missing_value(const SurfaceValue& value) {
    if (value.stored == Stored::direction) return "surface";
    const StandardOutput& output = *find_standard_output(value.output);
    if (value.stored == Stored::number) return shortest(output.value[0]);
    return "vec3(" + shortest(output.value[0]) + ", " + shortest(output.value[1]) + ", " +
           shortest(output.value[2]) + ")";
}

// Emission in units of `nits_of_unit_emission`.
std::string emission_of(const Shader& material) {
    const std::string color = output_expression(material, "emission", "vec3");
    const std::string luminance = output_expression(material, "emission_luminance", "float");
    if (color.empty() && luminance.empty()) return "vec3(0.0)";
    std::string value = color.empty() ? "vec3(1.0)" : color;
    if (!luminance.empty())
        value += " * (" + luminance + " / " + shortest(nits_of_unit_emission) + ")";
    return "max(" + value + ", 0.0)";
}

// The mesh's tangent, or a horizontal one where it has none.
constexpr std::string_view tangent_of_mesh =
    "(dot(WrView_tangent.xyz, WrView_tangent.xyz) > 0.0 ? WrView_tangent.xyz : "
    "cross(vec3(0.0, 1.0, 0.0), surface))";

// Expression of a value in main(), in object space.
std::string value_expression(const Shader& material, const SurfaceValue& value) {
    if (value.stored == Stored::radiance) return emission_of(material);
    const std::string found = output_expression(material, value.output, type_of(value.stored));
    if (!found.empty()) return found;
    return value.name == "tangent" ? std::string(tangent_of_mesh) : missing_value(value);
}

std::string in_world(const SurfaceValue& value, const std::string& expression) {
    if (value.stored != Stored::direction) return expression;
    const char* matrix =
        value.name == "tangent" ? "WrView_vector_to_world" : "WrView_normal_to_world";
    return std::string("WrView_octahedral(") + matrix + " * " + expression + ")";
}

// Appends the expressions of a value's slots; a radiance takes two slots per channel, the second
// one "".
void append_slots(std::vector<std::string>& slots, const SurfaceValue& value,
                  const std::string& variable) {
    const std::string divided =
        value.scale == 1 ? variable : variable + " / " + shortest(value.scale);
    if (value.stored == Stored::number) return slots.push_back(divided);
    for (const char* lane : {".x", ".y", ".z"}) {
        if (value.stored == Stored::direction && lane[1] == 'z') break;
        slots.push_back(variable + lane);
        if (value.stored == Stored::radiance) slots.emplace_back();
    }
}

std::string component(const std::vector<std::string>& slots, size_t first) {
    if (first >= slots.size()) return "0u";
    const std::string second = first + 1 < slots.size() ? slots[first + 1] : "0.0";
    if (second.empty()) return "floatBitsToUint(" + slots[first] + ")";
    return "WrView_pair(" + slots[first] + ", " + second + ")";
}

// Expression that reads a slot of the texels t0, t1, …
std::string read_slot(size_t slot) {
    const std::string bits =
        "t" + std::to_string(slot / slots_per_texel) + "." + "xyzw"[slot % slots_per_texel / 2];
    return "float(" + bits + (slot % 2 ? " >> 16u" : " & 0xffffu") + ") / 65535.0";
}

std::string read_radiance(size_t slot) {
    std::string text = "vec3(";
    for (size_t i = 0; i < 6; i += 2)
        text += std::string(i ? ", " : "") + "uintBitsToFloat(t" +
                std::to_string((slot + i) / slots_per_texel) + "." +
                "xyzw"[(slot + i) % slots_per_texel / 2] + ")";
    return text + ")";
}

std::string read_value(const SurfaceValue& value, size_t slot) {
    const std::string scale = value.scale == 1 ? "" : " * " + shortest(value.scale);
    switch (value.stored) {
        case Stored::number:
            return read_slot(slot) + scale;
        case Stored::direction:
            return "WrView_unit(" + read_slot(slot) + ", " + read_slot(slot + 1) + ")";
        case Stored::color:
            return "vec3(" + read_slot(slot) + ", " + read_slot(slot + 1) + ", " +
                   read_slot(slot + 2) + ")";
        case Stored::radiance:
            return read_radiance(slot);
    }
    return "";
}

}  // namespace

SurfaceModel surface_model(const Shader& material) {
    for (size_t i = plain_values; i < surface_values.size(); ++i)
        if (!output_expression(material, surface_values[i].output, "vec3").empty())
            return SurfaceModel::layered;
    return SurfaceModel::plain;
}

int surface_texels(SurfaceModel model) {
    return static_cast<int>((slots_of(model) + slots_per_texel - 1) / slots_per_texel);
}

std::string surface_outputs(SurfaceModel model) {
    std::string text =
        "uniform mat3 WrView_normal_to_world;\nuniform mat3 WrView_vector_to_world;\n"
        "uniform sampler2D WrView_nearer;\nuniform int WrView_layer;\n";
    for (int i = 0; i < surface_texels(model); ++i)
        text += "out uvec4 WrView_texel" + std::to_string(i) + ";\n";
    return text.append(pack_text);
}

std::string pack_surface(const Shader& material, SurfaceModel model) {
    std::string text;
    std::vector<std::string> slots;
    for (size_t i = 0; i < values_of(model); ++i) {
        const SurfaceValue& value = surface_values[i];
        const std::string variable = "WrView_value_" + std::string(value.name);
        const char* type =
            value.stored == Stored::direction ? "vec2" : type_of(value.stored).data();
        text += std::string("    ") + type + " " + variable + " = " +
                in_world(value, value_expression(material, value)) + ";\n";
        append_slots(slots, value, variable);
    }
    for (int i = 0; i < surface_texels(model); ++i) {
        text += "    WrView_texel" + std::to_string(i) + " = uvec4(";
        for (size_t k = 0; k < 4; ++k)
            text += (k ? ", " : "") +
                    component(slots, static_cast<size_t>(i) * slots_per_texel + 2 * k);
        text += ");\n";
    }
    return text + R"(    bool WrView_seen = WrView_layer > 0 && gl_FragCoord.z <=
        texelFetch(WrView_nearer, ivec2(gl_FragCoord.xy), 0).r;
    if (WrView_seen || WrView_value_opacity <= 0.0) discard;
)";
}

std::string unpack_surface(SurfaceModel model) {
    std::string members, reads, samplers;
    for (int i = 0; i < surface_texels(model); ++i) {
        const std::string number = std::to_string(i);
        samplers += "uniform usampler2D WrView_texel" + number + ";\n";
        reads += "    uvec4 t" + number + " = texelFetch(WrView_texel" + number + ", pixel, 0);\n";
    }
    size_t slot = 0;
    for (size_t i = 0; i < surface_values.size(); ++i) {
        const SurfaceValue& value = surface_values[i];
        const std::string name(value.name);
        members += "    " + std::string(type_of(value.stored)) + " " + name + ";\n";
        const bool stored = i < values_of(model);
        const bool direction = value.stored == Stored::direction;
        reads += "    s." + name + " = " +
                 (stored      ? read_value(value, slot)
                  : direction ? "s.surface"
                              : missing_value(value)) +
                 ";\n";
        slot += slots_of(value.stored);
    }
    return samplers + "\nstruct WrView_Surface {\n" + members + "};\n" + std::string(unpack_text) +
           "\nWrView_Surface WrView_read(ivec2 pixel) {\n    WrView_Surface s;\n" + reads +
           "    return s;\n}\n";
}

std::string output_expression(const Shader& material, std::string_view output,
                              std::string_view type) {
    const OutputInfo* found = output.empty() ? nullptr : find_output(material, std::string(output));
    if (!found) return "";
    return std::string(type) + "(" + output_text(material.reflection, *found, "WrView_m") + ")";
}

}  // namespace wrinkle::gpu
