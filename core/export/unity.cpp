// Unity: a shader of the Universal Render Pipeline that includes the graph's function, a material
// with the values of the inputs, and textures with import settings.
//
// Uniforms and images are properties of the material. Normals are computed in world space from
// Unity's object space, uvs with the origin at the bottom.
#include <algorithm>
#include <array>
#include <map>

#include "base/checksum.h"
#include "base/standard_outputs.h"
#include "base/text.h"
#include "compile/shader.h"
#include "export/files.h"
#include "export/host_text.h"
#include "export/hosts.h"
#include "export/texts.h"
#include "export/textures.h"
#include "ir/op.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

const Language& unity_hlsl() {
    static const Language language = [] {
        Language made = hlsl();
        made.image = "TEXTURE2D($n);\nSAMPLER(sampler$n);";
        made.spell(Op::sample_, "$n.Sample(sampler$n, $0)");
        made.spell(Op::sample_lod_, "$n.SampleLevel(sampler$n, $0, $1)");
        made.spell(Op::sample_grad_, "$n.SampleGrad(sampler$n, $0, $1, $2)");
        made.block = "CBUFFER_START(UnityPerMaterial)";
        made.block_member = "$t $n;";
        made.end_block = "CBUFFER_END";
        return made;
    }();
    return language;
}

// The GUID of an asset follows from its name, so that exporting again does not break references.
std::string guid_of(const std::string& name) {
    return sha256("wrinkle unity " + name).substr(0, 32);
}

const GraphInput* input_of(const ExportRequest& request, const UniformInfo& uniform) {
    const auto& inputs = request.project.top().inputs;
    const auto found = std::ranges::find(inputs, uniform.port, &GraphInput::name);
    return found == inputs.end() ? nullptr : &*found;
}

std::string property_label(const std::string& label) {
    std::string text;
    for (const char c : label)
        if (c != '"' && c != '\\') text += c;
    return "\"" + text + "\"";
}

// Four numbers, as Unity stores vectors; a color of three is opaque.
std::array<double, 4> four_values(const UniformInfo& uniform) {
    std::array<double, 4> values{0, 0, 0, 1};
    std::copy_n(uniform.value.begin(), info(uniform.type).lanes, values.begin());
    return values;
}

std::string vector_of(const UniformInfo& uniform) {
    std::string text;
    for (const double value : four_values(uniform))
        append_item(text, shortest(value));
    return "(" + text + ")";
}

std::string property(const ExportRequest& request, const UniformInfo& uniform) {
    const GraphInput* input = input_of(request, uniform);
    const std::string label =
        property_label(!input || input->label.empty() ? uniform.port : input->label);
    const bool is_number = info(uniform.type).lanes == 1;
    const auto range = input && is_number ? range_of(input->slider) : std::nullopt;
    std::string type = is_number ? "Float" : "Vector";
    if (range) type = "Range(" + shortest(range->least) + ", " + shortest(range->most) + ")";
    const bool is_color = input && input->type == "color";
    std::string value = is_number ? shortest(uniform.value[0]) : vector_of(uniform);
    return "        " + std::string(is_color ? "[HDR] " : "") + uniform.name + " (" + label + ", " +
           (is_color ? "Color" : type) + ") = " + value + "\n";
}

std::string properties(const ExportRequest& request, const Reflection& reflection) {
    std::string text;
    for (const UniformInfo& uniform : reflection.uniforms)
        text += property(request, uniform);
    for (const SamplerInfo& sampler : reflection.samplers)
        text += "        [NoScaleOffset] " + sampler.name + " (\"" +
                identifier(sampler.readers[0].node) + "\", 2D) = \"gray\" {}\n";
    return text;
}

const std::map<std::string_view, std::string_view> surface_inputs = {
    {"position", "i.positionOS"}, {"position_relative", "i.relativeOS"},
    {"normal", "i.normalOS"},     {"tangent", "i.tangentOS"},
    {"uv0", "i.uv01.xy"},         {"uv1", "i.uv01.zw"},
    {"uv2", "i.uv23.xy"},         {"uv3", "i.uv23.zw"},
    {"color0", "i.color"},        {"view", "normalize(-i.relativeOS)"},
    {"facing", "facing"},         {"normal_matrix", "(float3x3)GetWorldToObjectMatrix()"},
};

std::string unity_emission(const Reflection& reflection) {
    const bool color = has_output(reflection, "emission");
    const bool luminance = has_output(reflection, "emission_luminance");
    if (!color && !luminance) return "0.0";
    const auto output = [&](std::string_view name) {
        return output_expression(reflection, unity_hlsl(), name);
    };
    std::string text = output("emission");
    if (luminance)
        text +=
            " * (" + output("emission_luminance") + " / " + shortest(nits_of_unit_emission) + ".0)";
    return "max(" + text + ", 0.0)";
}

std::string unity_call(const Reflection& reflection) {
    std::string text;
    if (!reflection.struct_name.empty())
        text = "    " + reflection.struct_name + " s;\n" +
               surface_assignments(reflection, surface_inputs);
    text += "    " + reflection.result_name + " m = " + call_text(reflection, "s") + ";\n";
    return indented(text, 12);
}

std::string unity_albedo(const Reflection& reflection) {
    const auto output = [&](std::string_view name) {
        return output_expression(reflection, unity_hlsl(), name);
    };
    std::string text = "float3 albedo = " + output("color") + " * " + output("base_weight") + ";\n";
    if (has_output(reflection, "coat_weight")) text += coat_text(unity_hlsl(), "albedo", output);
    return text;
}

std::string unity_shader(const ExportRequest& request, const Reflection& reflection) {
    const auto output = [&](std::string_view name) {
        return output_expression(reflection, unity_hlsl(), name);
    };
    const bool cut = has_output(reflection, "opacity");
    return with_fields(texts::unity_shader,
                       {{"NAME", request.name},
                        {"PROPERTIES", properties(request, reflection)},
                        {"RENDER_TYPE", cut ? "TransparentCutout" : "Opaque"},
                        {"QUEUE", cut ? "AlphaTest" : "Geometry"},
                        {"CULL", request.double_sided ? "Off" : "Back"},
                        {"HAS_COAT", has_output(reflection, "coat_weight") ? "1" : "0"},
                        {"CALL", unity_call(reflection)},
                        {"ALBEDO", indented(unity_albedo(reflection), 16)},
                        {"METALNESS", output("metalness")},
                        {"ROUGHNESS", output("roughness")},
                        {"OCCLUSION", output("occlusion")},
                        {"EMISSION", unity_emission(reflection)},
                        {"OPACITY", output("opacity")},
                        {"COAT_WEIGHT", output("coat_weight")},
                        {"COAT_ROUGHNESS", output("coat_roughness")},
                        {"CUTOFF", cut ? "0.5" : "0.0"},
                        {"NORMAL", has_output(reflection, "normal")
                                       ? output("normal")
                                       : "TransformObjectToWorldNormal(i.normalOS) * facing"}});
}

std::string include_text(const ExportRequest& request, const std::string& function) {
    const std::string guard = "WRINKLE_" + request.name + "_INCLUDED";
    return "#ifndef " + guard + "\n#define " + guard + "\n" + function + "#endif\n";
}

std::string texture_entry(const std::string& property, const std::string& texture) {
    return "    - " + property + ":\n        m_Texture: {fileID: 2800000, guid: " + texture +
           ", type: 3}\n        m_Scale: {x: 1, y: 1}\n        m_Offset: {x: 0, y: 0}\n";
}

std::string color_entry(const UniformInfo& uniform) {
    constexpr std::string_view names[] = {"r", "g", "b", "a"};
    const std::array<double, 4> values = four_values(uniform);
    std::string list;
    for (size_t i = 0; i < 4; ++i)
        append_item(list, std::string(names[i]) + ": " + shortest(values[i]));
    return "    - " + uniform.name + ": {" + list + "}\n";
}

std::string material_text(const ExportRequest& request, const Reflection& reflection,
                          const std::vector<ExportedTexture>& textures) {
    std::string floats, colors, maps;
    for (const UniformInfo& uniform : reflection.uniforms)
        if (info(uniform.type).lanes == 1)
            floats += "    - " + uniform.name + ": " + shortest(uniform.value[0]) + "\n";
        else
            colors += color_entry(uniform);
    for (const ExportedTexture& texture : textures)
        maps += texture_entry(texture.sampler, guid_of(texture.file));
    return "%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n--- !u!21 &2100000\nMaterial:\n"
           "  serializedVersion: 8\n  m_Name: " +
           request.name +
           "\n  m_Shader: {fileID: 4800000, guid: " + guid_of(request.name + ".shader") +
           ", type: 3}\n  m_SavedProperties:\n    serializedVersion: 3\n    m_TexEnvs:" +
           (maps.empty() ? " []" : "") + "\n" + maps +
           "    m_Floats:" + (floats.empty() ? " []" : "") + "\n" + floats +
           "    m_Colors:" + (colors.empty() ? " []" : "") + "\n" + colors;
}

std::string meta_text(const std::string& name, const std::string& importer) {
    return "fileFormatVersion: 2\nguid: " + guid_of(name) + "\n" + importer;
}

std::string texture_importer(const ExportedTexture& texture) {
    const int wrap = texture.options.wrap == Wrap::repeat  ? 0
                     : texture.options.wrap == Wrap::clamp ? 1
                                                           : 2;
    const int filter = texture.options.filter == Filter::nearest ? 0 : 2;
    return "TextureImporter:\n  serializedVersion: 12\n  mipmaps:\n    enableMipMap: 1\n"
           "    sRGBTexture: " +
           std::to_string(int{texture.srgb}) + "\n  textureSettings:\n    serializedVersion: 2\n" +
           "    filterMode: " + std::to_string(filter) + "\n    wrapU: " + std::to_string(wrap) +
           "\n    wrapV: " + std::to_string(wrap) +
           "\n  maxTextureSize: 16384\n  textureCompression: 0\n  textureType: 0\n"
           "  nPOTScale: 0\n";
}

constexpr std::string_view shader_importer = "ShaderImporter:\n  externalObjects: {}\n";
constexpr std::string_view include_importer = "ShaderIncludeImporter:\n  externalObjects: {}\n";
constexpr std::string_view material_importer =
    "NativeFormatImporter:\n  mainObjectFileID: 2100000\n";

constexpr std::string_view unity_lacks[] = {"specular_weight",
                                            "specular_color",
                                            "specular_ior",
                                            "specular_roughness_anisotropy",
                                            "tangent",
                                            "base_diffuse_roughness",
                                            "coat_normal",
                                            "coat_roughness_anisotropy",
                                            "fuzz_weight",
                                            "subsurface_weight",
                                            "transmission_weight",
                                            "thin_film_weight",
                                            "displacement"};

std::string unity_readme(const ExportRequest& request) {
    return "Copy this folder into Assets/ of a project with the Universal Render Pipeline, and "
           "drag " +
           request.name + R"(.mat onto an object.

The shader runs the graph's own function; its inputs are properties of the material. Meshes need
normals, and tangents if the graph uses the vertex frame (Model importer: Calculate Mikktspace).
Textures have import settings: linear unless they are colors, not compressed, wrap as in the graph.

)" + request.name +
           R"(.hlsl can be included in other shaders: fill its struct and call its function.
Written by the documentation of Unity 2022 LTS; it was not tried in Unity.
)";
}

}  // namespace

bool write_unity(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    const Target target = [] {
        Target made = *find_target("hlsl");
        made.language = unity_hlsl;
        return made;
    }();
    ShaderOptions options;
    options.emit.name = request.name;
    options.emit.target = &target;
    options.emit.normal_space = NormalSpace::world;
    const MadeShader made = make_shader(request.project, request.registry, options, diagnostics);
    if (diagnostics.has_errors()) return false;
    const Reflection& reflection = made.shader.reflection;
    for (const std::string_view output : unity_lacks)
        if (has_output(reflection, output)) warn_unsupported(request, "URP", output, diagnostics);
    const auto textures = copy_textures(reflection, folder, diagnostics);
    const auto write = [&](const std::string& name, const std::string& text,
                           std::string_view importer) {
        return write_export_file(folder / name, text, diagnostics) &&
               write_export_file(folder / (name + ".meta"), meta_text(name, std::string(importer)),
                                 diagnostics);
    };
    for (const ExportedTexture& texture : textures)
        if (!write_export_file(folder / (texture.file + ".meta"),
                               meta_text(texture.file, texture_importer(texture)), diagnostics))
            return false;
    return !diagnostics.has_errors() &&
           write(request.name + ".hlsl", include_text(request, made.shader.source),
                 include_importer) &&
           write(request.name + ".shader", unity_shader(request, reflection), shader_importer) &&
           write(request.name + ".mat", material_text(request, reflection, textures),
                 material_importer) &&
           write_readme(request, "Unity", unity_readme(request), folder, diagnostics);
}

}  // namespace wrinkle
