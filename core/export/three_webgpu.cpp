// three.js with WebGPURenderer: a MeshPhysicalNodeMaterial of the graph's function in WGSL.
//
// One call computes all outputs and stores them in a private variable, from which one function for
// each output reads: TSL's calls return single values.
#include <algorithm>

#include "base/standard_outputs.h"
#include "base/text.h"
#include "export/files.h"
#include "export/host_text.h"
#include "export/texts.h"
#include "export/three_text.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

// Inputs are private variables, images are parameters: TSL binds both.
const Language& tsl_wgsl() {
    static const Language language = [] {
        Language made = wgsl();
        made.image = "";
        made.image_parameter = "$n: texture_2d<f32>, $n_sampler: sampler";
        made.image_argument = "$n, $n_sampler";
        made.end_block = "}\nvar<private> $v: $n;";
        return made;
    }();
    return language;
}

const std::map<std::string_view, std::string_view> tsl_inputs = {
    {"position", "positionGeometry"},
    {"position_relative", "varying(positionGeometry.sub(EYE))"},
    {"normal", "normalGeometry"},
    {"tangent", "surfaceTangent(at(0))"},
    {"uv0", "at(0)"},
    {"uv1", "at(1)"},
    {"uv2", "at(2)"},
    {"uv3", "at(3)"},
    {"color0", "attribute('color', 'vec4')"},
    {"view", "TO_EYE.normalize()"},
    {"facing", "select(frontFacing, float(1), float(-1))"},
};

class TslText {
public:
    explicit TslText(const Reflection& reflection) : reflection_(reflection) {}

    std::string parameters() const {
        std::string list;
        for (const MemberInfo& member : reflection_.members)
            append_item(list, member.name + ": " + std::string(tsl_wgsl().type(member.type)));
        for (const UniformInfo& uniform : reflection_.uniforms)
            append_item(list,
                        "wr_" + uniform.port + ": " + std::string(tsl_wgsl().type(uniform.type)));
        for (const SamplerInfo& sampler : reflection_.samplers)
            append_item(list, filled(tsl_wgsl().image_parameter, {{'n', sampler.name}}));
        return list;
    }

    // Fills the inputs and the surface.
    std::string call() const {
        std::string text;
        for (const UniformInfo& uniform : reflection_.uniforms)
            text += "    " + reflection_.parameter_block->variable + "." + uniform.name + " = wr_" +
                    uniform.port + ";\n";
        if (reflection_.struct_name.empty()) return text;
        text += "    var s: " + reflection_.struct_name + ";\n";
        for (const MemberInfo& member : reflection_.members)
            text += "    s." + member.name + " = " + member.name + ";\n";
        return text;
    }

    std::string invoke() const {
        std::string list = reflection_.struct_name.empty() ? "" : "s";
        for (const SamplerInfo& sampler : reflection_.samplers)
            append_item(list, filled(tsl_wgsl().image_argument, {{'n', sampler.name}}));
        return reflection_.function + "(" + list + ")";
    }

    std::string arguments() const {
        std::string list;
        for (const MemberInfo& member : reflection_.members)
            append_item(list, member.name + ": " + std::string(tsl_inputs.at(member.name)));
        for (const UniformInfo& uniform : reflection_.uniforms)
            append_item(list, "wr_" + uniform.port + ": nodes[" + json_quoted(uniform.port) + "]");
        for (const SamplerInfo& sampler : reflection_.samplers)
            append_item(list, sampler.name + ": images." + sampler.name + ", " + sampler.name +
                                  "_sampler: sampler(images." + sampler.name + ")");
        return list;
    }

    // A function for each output.
    std::string outputs() const {
        std::string text;
        if (has_output(reflection_, "coat_weight")) text += texts::three_coat_js;
        for (const OutputInfo& output : reflection_.outputs) {
            const std::string type(tsl_wgsl().type(output.type));
            text += "const output_" + output.member + " = wgslFn(`\nfn wrinkle_" +
                    reflection_.name + "_" + output.member + "(done: f32) -> " + type +
                    " { return wrinkle_result." + output.member + " + " + type +
                    "(done); }`, [code]);\n";
        }
        return text;
    }

    // A function for the vertex stage, of a graph with displacement.
    std::string displacement(const std::string& source) const {
        return "const displace = wgslFn(`\nfn wrinkle_" + reflection_.name + "_displace(" +
               parameters() + ") -> f32 {\n" + call() + "    return " + invoke() +
               ";\n}`, [wgsl(`\n" + template_literal_text(source) + "`)]);\n";
    }

    std::string displaced() const {
        return "    this.#position = positionGeometry.add(\n        "
               "normalGeometry.normalize().mul(displace({" +
               arguments() + "})));\n";
    }

    std::string nodes() const {
        std::string text;
        const auto add = [&](std::string_view needed, const std::string& property,
                             const std::string& expression) {
            if (has_output(reflection_, needed))
                text += "    this." + property + "Node = " + expression + ";\n";
        };
        text += "    this.colorNode = vec4(" + base() + ", " + value("opacity") + ");\n";
        text += "    this.roughnessNode = " + value("roughness") + ";\n";
        text += "    this.metalnessNode = " + value("metalness") + ";\n";
        add("normal", "normal", "normalToView(" + value("normal") + ")");
        add("occlusion", "ao", value("occlusion"));
        add("emission", "emissive", emission());
        if (!has_output(reflection_, "emission")) add("emission_luminance", "emissive", emission());
        add("specular_ior", "ior", value("specular_ior"));
        add("specular_weight", "specularIntensity", value("specular_weight"));
        add("specular_color", "specularColor", value("specular_color"));
        add("coat_weight", "clearcoat", coat_weight());
        add("coat_weight", "clearcoatRoughness", value("coat_roughness"));
        add("coat_normal", "clearcoatNormal", "normalToView(" + value("coat_normal") + ")");
        add("fuzz_weight", "sheen", value("fuzz_color") + ".mul(" + value("fuzz_weight") + ")");
        add("fuzz_weight", "sheenRoughness", value("fuzz_roughness") + ".pow(1.5)");
        add("transmission_weight", "transmission", value("transmission_weight"));
        add("thin_film_weight", "iridescence", value("thin_film_weight"));
        add("thin_film_weight", "iridescenceIOR", value("thin_film_ior"));
        add("thin_film_weight", "iridescenceThickness",
            value("thin_film_thickness") + ".mul(1000)");
        return text;
    }

private:
    // A node of the output, or of its default.
    std::string value(std::string_view output) const {
        if (has_output(reflection_, output)) return "output_" + member(output) + "({done})";
        const StandardOutput& row = *find_standard_output(output);
        if (row.type != "color") return "float(" + shortest(row.value[0]) + ")";
        return "vec3(" + shortest(row.value[0]) + ", " + shortest(row.value[1]) + ", " +
               shortest(row.value[2]) + ")";
    }
    std::string member(std::string_view output) const {
        return std::ranges::find(reflection_.outputs, output, &OutputInfo::output)->member;
    }

    std::string base() const {
        const std::string color = value("color") + ".mul(" + value("base_weight") + ")";
        if (!has_output(reflection_, "coat_weight")) return color;
        return "coated({color: " + color + ", roughness: " + value("roughness") +
               ", metalness: " + value("metalness") + ", weight: " + value("coat_weight") +
               ", tint: " + value("coat_color") + ", n: " + value("coat_ior") +
               ", darkening: " + value("coat_darkening") + "})";
    }

    std::string emission() const {
        std::string text = value("emission");
        if (has_output(reflection_, "emission_luminance"))
            text += ".mul(" + value("emission_luminance") + ".div(" +
                    shortest(nits_of_unit_emission) + "))";
        return text + ".max(0)";
    }

    // The reflectance of coat_ior over that of three.js's coat, 0.04.
    std::string coat_weight() const {
        const std::string ior = value("coat_ior");
        return value("coat_weight") + ".mul(" + ior + ".sub(1).div(" + ior +
               ".add(1)).pow(2).div(0.04)).saturate()";
    }

    const Reflection& reflection_;
};

std::string tsl_properties(const ExportRequest& request, const Reflection& reflection) {
    std::string list;
    if (has_output(reflection, "opacity")) append_item(list, "alphaTest: 0.5");
    if (request.double_sided) append_item(list, "side: THREE.DoubleSide");
    return list;
}

}  // namespace

bool write_three_webgpu(const ExportRequest& request, const std::vector<ExportedTexture>& textures,
                        const std::filesystem::path& folder, Diagnostics& diagnostics) {
    Target target = *find_target("wgsl");
    target.language = tsl_wgsl;
    ShaderOptions options;
    options.emit.name = request.name;
    options.emit.target = &target;
    Diagnostics found;  // those of WebGL's function again
    const MadeShader made = make_shader(request.project, request.registry, options, found);
    if (found.has_errors()) return diagnostics.append(found), false;
    const Reflection& reflection = made.shader.reflection;
    const TslText text(reflection);
    const Shader vertex = three_displacement(request, reflection, target, diagnostics);
    const TslText vertex_text(vertex.reflection);
    const bool displaced = !vertex.source.empty();
    const std::string module =
        with_fields(texts::three_webgpu_js,
                    {{"NAME", request.name},
                     {"CLASS", three_class(request.name)},
                     {"IMPORTS", three_imports(textures)},
                     {"FUNCTION", template_literal_text(made.shader.source)},
                     {"RESULT", reflection.result_name},
                     {"INPUTS", three_input_list(made, request)},
                     {"PRESETS", three_presets(request)},
                     {"UNIFORMS", three_uniforms(request, reflection)},
                     {"TEXTURES", three_textures(textures)},
                     {"LOADER", three_loader(textures)},
                     {"COMMON", std::string(texts::three_common_js)},
                     {"PARAMETERS", text.parameters()},
                     {"CALL", text.call()},
                     {"INVOKE", text.invoke()},
                     {"OUTPUTS", text.outputs()},
                     {"DISPLACEMENT", displaced ? vertex_text.displacement(vertex.source) : ""},
                     {"DISPLACE", displaced ? vertex_text.displaced() : ""},
                     {"PROPERTIES", tsl_properties(request, reflection)},
                     {"ARGUMENTS", text.arguments()},
                     {"NODES", text.nodes()}});
    return write_export_file(folder / (request.name + ".webgpu.js"), module, diagnostics);
}

}  // namespace wrinkle
