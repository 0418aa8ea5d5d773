// three.js: an ES module with a MeshPhysicalMaterial that runs the graph's function, and a page
// that shows it on the mesh.
//
// The function is called at the beginning of the fragment shader, in the object space of the
// geometry at rest; each chunk of three.js's shader is followed by the values that it computes.
// Normals are returned in view space. Uvs have their origin at the bottom, as textures with flipY.
#include <algorithm>

#include "base/checksum.h"
#include "base/standard_outputs.h"
#include "base/text.h"
#include "compile/shader.h"
#include "export/files.h"
#include "export/glb.h"
#include "export/host_text.h"
#include "export/hosts.h"
#include "export/texts.h"
#include "export/textures.h"
#include "export/three_text.h"
#include "ir/op.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

const std::map<std::string_view, std::string_view> three_inputs = {
    {"position", "wrinkle_position"}, {"position_relative", "wrinkle_relative"},
    {"normal", "wrinkle_normal"},     {"tangent", "wrinkle_surface_tangent()"},
    {"uv0", "wrinkle_uv01.xy"},       {"uv1", "wrinkle_uv01.zw"},
    {"uv2", "wrinkle_uv23.xy"},       {"uv3", "wrinkle_uv23.zw"},
    {"color0", "wrinkle_color"},      {"view", "normalize(wrinkle_to_eye)"},
    {"facing", "wrinkle_facing"},     {"normal_matrix", "wrinkle_normal_matrix"},
};

// The code that follows the chunks of the fragment shader. Its result is the variable `wrinkle`.
class ThreeText {
public:
    explicit ThreeText(const Reflection& reflection) : reflection_(reflection) {}

    bool has(std::string_view output) const { return has_output(reflection_, output); }
    std::string value(std::string_view output) const {
        return output_expression(reflection_, glsl(), output, "wrinkle");
    }

    std::string base() const {
        std::string text = reflection_.result_name + " wrinkle;\n{\n";
        if (!reflection_.struct_name.empty())
            text += "    " + reflection_.struct_name + " s;\n" +
                    surface_assignments(reflection_, three_inputs);
        text += "    wrinkle = " + call_text(reflection_, "s") + ";\n}\n";
        text += "diffuseColor.rgb *= " + value("color") + " * " + value("base_weight") + ";\n";
        if (has("coat_weight"))
            text += coat_text(glsl(), "diffuseColor.rgb",
                              [&](std::string_view output) { return value(output); });
        if (has("opacity")) text += "diffuseColor.a *= " + value("opacity") + ";\n";
        return text;
    }

    std::string roughness() const {
        return "roughnessFactor *= " + value("roughness") +
               ";\nmetalnessFactor = " + value("metalness") + ";\n";
    }

    std::string emission() const {
        if (!has("emission") && !has("emission_luminance")) return {};
        std::string text = "totalEmissiveRadiance = max(" + value("emission");
        if (has("emission_luminance"))
            text += " * (" + value("emission_luminance") + " / " + shortest(nits_of_unit_emission) +
                    ".0)";
        return text + ", 0.0);\n";
    }

    std::string lights() const {
        std::string text;
        if (has("specular_ior") || has("specular_weight") || has("specular_color"))
            text += specular();
        if (has("base_diffuse_roughness"))
            text += guarded("USE_DIFFUSE_ROUGHNESS",
                            "material.diffuseRoughness = " + value("base_diffuse_roughness") + ";");
        if (has("coat_weight")) text += coat();
        if (has("fuzz_weight"))
            text += guarded("USE_SHEEN", "material.sheenColor = " + value("fuzz_weight") + " * " +
                                             value("fuzz_color") +
                                             ";\nmaterial.sheenRoughness = clamp(pow(" +
                                             value("fuzz_roughness") + ", 1.5), 0.0001, 1.0);");
        if (has("thin_film_weight"))
            text += guarded("USE_IRIDESCENCE",
                            "material.iridescence = " + value("thin_film_weight") +
                                ";\nmaterial.iridescenceIOR = " + value("thin_film_ior") +
                                ";\nmaterial.iridescenceThickness = 1000.0 * " +
                                value("thin_film_thickness") + ";");
        if (has("specular_roughness_anisotropy")) text += anisotropy();
        return text;
    }

    // Properties that switch the parts of three.js's shader on.
    std::string properties() const {
        std::string list = "metalness: 1";
        const auto add = [&](std::string_view output, const char* property) {
            if (has(output)) append_item(list, property);
        };
        add("coat_weight", "clearcoat: 1");
        add("fuzz_weight", "sheen: 1");
        add("thin_film_weight", "iridescence: 1");
        add("specular_roughness_anisotropy", "anisotropy: 1");
        add("transmission_weight", "transmission: 1");
        add("base_diffuse_roughness", "diffuseRoughness: 1");
        add("opacity", "alphaTest: 0.5");
        return list;
    }

private:
    static std::string guarded(const std::string& name, const std::string& code) {
        return "#ifdef " + name + "\n" + code + "\n#endif\n";
    }

    std::string specular() const {
        return "material.ior = " + value("specular_ior") +
               ";\n"
               "material.specularF90 = mix(min(" +
               value("specular_weight") +
               ", 1.0), 1.0, metalnessFactor);\n"
               "material.specularColor = min(pow2((material.ior - 1.0) / (material.ior + 1.0)) * " +
               value("specular_color") + " * " + value("specular_weight") +
               ", vec3(1.0));\n"
               "material.specularColorBlended = mix(material.specularColor, diffuseColor.rgb, "
               "metalnessFactor);\n";
    }

    std::string coat() const {
        const std::string ior = value("coat_ior");
        return guarded("USE_CLEARCOAT", "material.clearcoat = saturate(" + value("coat_weight") +
                                            ");\n"
                                            "material.clearcoatRoughness = min(max(" +
                                            value("coat_roughness") +
                                            ", 0.045) + geometryRoughness, 1.0);\n"
                                            "material.clearcoatF0 = vec3(pow2((" +
                                            ior + " - 1.0) / (" + ior + " + 1.0)));");
    }

    // The lobe of OpenPBR: host_roughness().
    std::string anisotropy() const {
        std::string text = "float across = 1.0 - " + value("specular_roughness_anisotropy") +
                           ";\n"
                           "float along = min(pow2(material.roughness) * sqrt(2.0 / (1.0 + across "
                           "* across)), 1.0);\n"
                           "material.alphaT = along;\n"
                           "material.roughness = max(sqrt(across * along), 0.045);\n"
                           "material.anisotropy = 1.0;\n";
        if (has("tangent"))
            text += "vec3 stretched = inverse(transpose(wrinkle_normal_matrix)) * " +
                    value("tangent") +
                    ";\n"
                    "material.anisotropyT = normalize(stretched - normal * dot(normal, "
                    "stretched));\n"
                    "material.anisotropyB = cross(normal, material.anisotropyT);\n";
        return guarded("USE_ANISOTROPY", text);
    }

    const Reflection& reflection_;
};

ShaderOptions three_options(const ExportRequest& request) {
    ShaderOptions options;
    options.emit.name = request.name;
    options.emit.target = find_target("essl300");
    options.emit.normal_space = NormalSpace::view;
    return options;
}

std::string displace_text(const Shader& shader) {
    if (shader.source.empty()) return {};
    const Reflection& reflection = shader.reflection;
    std::string text = "{\n";
    if (!reflection.struct_name.empty())
        text += "    " + reflection.struct_name + " s;\n" +
                surface_assignments(reflection, three_inputs);
    return text + "    transformed += normalize(objectNormal) * " + call_text(reflection, "s") +
           ";\n}\n";
}

std::string module_text(const ExportRequest& request, const MadeShader& made,
                        const Shader& displacement, const std::vector<ExportedTexture>& textures) {
    const Reflection& reflection = made.shader.reflection;
    const ThreeText text(reflection);
    return with_fields(
        texts::three_js,
        {{"TITLE", request.name},
         {"NAME", request.name},
         {"CLASS", three_class(request.name)},
         {"IMPORTS", three_imports(textures)},
         {"FUNCTION", template_literal_text(made.shader.source)},
         {"DISPLACEMENT", template_literal_text(displacement.source)},
         {"INPUTS", three_input_list(made, request)},
         {"PRESETS", three_presets(request)},
         {"UNIFORMS", three_uniforms(request, reflection)},
         {"TEXTURES", three_textures(textures)},
         {"LOADER", three_loader(textures)},
         {"DISPLACE", displace_text(displacement)},
         {"BASE", text.base()},
         {"ROUGHNESS", text.roughness()},
         {"NORMAL", text.has("normal") ? "normal = " + text.value("normal") + ";\n" : ""},
         {"COAT_NORMAL",
          text.has("coat_normal") ? "clearcoatNormal = " + text.value("coat_normal") + ";\n" : ""},
         {"EMISSION", text.emission()},
         {"LIGHTS", text.lights()},
         {"OCCLUSION", text.value("occlusion")},
         {"TRANSMISSION", text.value("transmission_weight")},
         {"PROPERTIES",
          text.properties() + (request.double_sided ? ", side: THREE.DoubleSide" : "")},
         {"COMMON", std::string(texts::three_common_js)},
         {"HASH", sha256(made.shader.source).substr(0, 16)}});
}

constexpr std::string_view three_lacks[] = {
    "coat_roughness_anisotropy", "coat_tangent",         "subsurface_weight",
    "transmission_color",        "transmission_scatter", "transmission_dispersion_scale"};

std::string three_readme(const ExportRequest& request, bool has_textures) {
    const std::string type = three_class(request.name);
    return "npm start\n\nshows the material in a browser, with controls of its inputs (Node.js 18 "
           "or later; it installs\nthree.js and a static server into this folder).\n\nTo use it in "
           "a project, copy " +
           request.name + (has_textures ? ".js and textures/" : ".js") + ", then\n\n    import {" +
           type + "} from './" + request.name + ".js';\n    mesh.material = new " + type +
           "();                     // geometries of three.js\n    mesh.material = new " + type +
           "({uvOrigin: 'top'});    // meshes of GLTFLoader\n    mesh.material.inputs.NAME = "
           "VALUE;\n\n`inputs` and `presets` of the module describe the inputs." +
           std::string(has_textures ? " material.ready is a promise of its textures." : "") + "\n" +
           request.name + ".webgpu.js has the same for WebGPURenderer.\nMade for three.js r187.\n";
}

bool write_page(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    const std::string page = with_fields(
        texts::three_html,
        {{"NAME", request.name}, {"TITLE", request.name}, {"CLASS", three_class(request.name)}});
    const std::string package =
        with_fields(texts::three_package_json, {{"PACKAGE", lower_case(request.name)}});
    const std::string mesh =
        Glb().bytes(request.mesh, request.name, {{"name", json::Value::string(request.name)}}, {},
                    GlbColors::color);
    return write_export_file(folder / "index.html", page, diagnostics) &&
           write_export_file(folder / "package.json", package, diagnostics) &&
           write_export_file(folder / "mesh.glb", mesh, diagnostics);
}

}  // namespace

bool write_three(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    const MadeShader made =
        make_shader(request.project, request.registry, three_options(request), diagnostics);
    if (diagnostics.has_errors()) return false;
    const Reflection& reflection = made.shader.reflection;
    const Shader displacement =
        three_displacement(request, reflection, *find_target("essl300"), diagnostics);
    for (const std::string_view output : three_lacks)
        if (has_output(reflection, output))
            warn_unsupported(request, "three.js", output, diagnostics);
    warn_of_mesh(request, reflection, diagnostics);
    const auto textures = copy_textures(reflection, folder, diagnostics);
    if (diagnostics.has_errors()) return false;
    return write_export_file(folder / (request.name + ".js"),
                             module_text(request, made, displacement, textures), diagnostics) &&
           write_three_webgpu(request, textures, folder, diagnostics) &&
           write_page(request, folder, diagnostics) &&
           write_readme(request, "three.js", three_readme(request, !textures.empty()), folder,
                        diagnostics);
}

}  // namespace wrinkle
