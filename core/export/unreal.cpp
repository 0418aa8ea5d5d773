// Unreal Engine: baked maps with green down, a script of the editor that imports them and builds
// the material, and the graph's function for Custom nodes.
#include <algorithm>

#include "base/srgb.h"
#include "base/text.h"
#include "compile/shader.h"
#include "export/files.h"
#include "export/host_text.h"
#include "export/host_values.h"
#include "export/hosts.h"
#include "export/texts.h"
#include "image/load.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

// Images and inputs are parameters: an .ush file has no resources.
const Language& unreal_hlsl() {
    static const Language language = [] {
        Language made = hlsl();
        made.image = "";
        made.image_parameter = "Texture2D $n, SamplerState $n_sampler";
        made.image_argument = "$n, $n_sampler";
        made.block = "struct $n {";
        made.block_member = "$t $n;";
        made.block_use = "$v.$n";
        made.block_parameter = "$t $n";
        made.block_argument = "$n";
        return made;
    }();
    return language;
}

using Texel = std::array<float, 4>;

// Maps of the material, and the lines of the script that import and connect them.
class UnrealMaps {
public:
    UnrealMaps(const ExportRequest& request, const BakedMaterial& baked, const fs::path& folder,
               Diagnostics& diagnostics)
        : request_(request), baked_(baked), folder_(folder), diagnostics_(diagnostics) {}

    std::string parts() {
        color(
            "BC", base_color_outputs(baked_),
            [&](size_t texel) { return host_base_color(baked_, texel); }, "MP_BASE_COLOR");
        if (emits(baked_))
            color(
                "E", {"emission", "emission_luminance"},
                [&](size_t texel) { return host_emission(baked_, texel); }, "MP_EMISSIVE_COLOR");
        packed();
        coat();
        normal();
        height();
        return parts_;
    }

private:
    void add(const std::string& kind, const std::string& arguments, const std::string& pins) {
        parts_ += "    (\"" + kind + "\", (" + arguments + ",), [" + pins + "]),\n";
    }
    static std::string pin(const std::string& output, const std::string& property) {
        return "(\"" + output + "\", PROPERTY." + property + ")";
    }
    std::string texture_name(const std::string& suffix) const {
        return "T_" + request_.name + "_" + suffix;
    }

    void save(const std::string& suffix, uint32_t channels, PixelType type,
              const std::function<Texel(size_t)>& texel) {
        WriterOptions options;
        options.type = type;
        const fs::path path = folder_ / "textures" / (texture_name(suffix) + ".png");
        std::error_code error;
        fs::create_directories(path.parent_path(), error);
        save_image(composed(baked_, channels, texel), path, options, diagnostics_);
    }

    void color(const std::string& suffix, std::initializer_list<std::string_view> outputs,
               const std::function<std::array<float, 3>(size_t)>& of, const std::string& property) {
        if (baked_.all_constant(outputs)) {
            std::string list;
            for (const float channel : of(0))
                append_item(list, shortest(channel));
            return add("constant", list, pin("", property));
        }
        save(suffix, 3, PixelType::u8, [&](size_t texel) {
            Texel made{};
            const auto linear = of(texel);
            for (size_t i = 0; i < 3; ++i)
                made[i] = static_cast<float>(srgb_from_linear(std::clamp(linear[i], 0.0F, 1.0F)));
            return made;
        });
        add("color", json_quoted(texture_name(suffix)), pin("RGB", property));
    }

    void number(std::string_view output, const std::string& property) {
        add("constant", shortest(baked_.at(output, 0)[0]), pin("", property));
    }

    // Occlusion, roughness and metalness; with an opacity in alpha.
    void packed() {
        const bool has_opacity = baked_.find("opacity");
        if (baked_.all_constant({"occlusion", "roughness", "metalness", "opacity"})) {
            number("roughness", "MP_ROUGHNESS");
            number("metalness", "MP_METALLIC");
            if (has_opacity) number("opacity", "MP_OPACITY_MASK");
            return;
        }
        save("ORM", has_opacity ? 4 : 3, PixelType::u8, [&](size_t texel) {
            return Texel{baked_.at("occlusion", texel)[0], baked_.at("roughness", texel)[0],
                         baked_.at("metalness", texel)[0], baked_.at("opacity", texel)[0]};
        });
        std::string pins = pin("R", "MP_AMBIENT_OCCLUSION") + ", " + pin("G", "MP_ROUGHNESS") +
                           ", " + pin("B", "MP_METALLIC");
        if (has_opacity) pins += ", " + pin("A", "MP_OPACITY_MASK");
        add("data", json_quoted(texture_name("ORM")), pins);
    }

    void coat() {
        if (!baked_.find("coat_weight")) return;
        save("C", 3, PixelType::u8, [&](size_t texel) {
            return Texel{host_coat_weight(baked_, texel), baked_.at("coat_roughness", texel)[0], 0,
                         1};
        });
        add("data", json_quoted(texture_name("C")),
            pin("R", "MP_CUSTOM_DATA0") + ", " + pin("G", "MP_CUSTOM_DATA1"));
    }

    void normal() {
        if (!baked_.find("normal")) return;
        save("N", 3, PixelType::u16, [&](size_t texel) {
            const auto m = baked_.at("normal", texel);
            return Texel{(m[0] + 1) / 2, (1 - m[1]) / 2, (m[2] + 1) / 2, 1};
        });
        add("normal", json_quoted(texture_name("N")), pin("RGB", "MP_NORMAL"));
    }

    // Black is the lowest height, white the highest; imported, not connected.
    void height() {
        const BakedOutput* found = baked_.find("displacement");
        if (!found) found = baked_.find("height");
        if (!found || found->constant) return;
        const auto [low, high] = std::ranges::minmax(found->texels);
        save("H", 1, PixelType::u16, [&, low = low, high = high](size_t texel) {
            return Texel{(found->texels[texel] - low) / (high - low), 0, 0, 0};
        });
        add("data", json_quoted(texture_name("H")), "");
    }

    const ExportRequest& request_;
    const BakedMaterial& baked_;
    const fs::path& folder_;
    Diagnostics& diagnostics_;
    std::string parts_;
};

std::string unreal_settings(const BakedMaterial& baked) {
    std::string text;
    if (baked.find("opacity"))
        text +=
            "    material.set_editor_property(\"blend_mode\", "
            "unreal.BlendMode.BLEND_MASKED)\n";
    if (baked.find("coat_weight"))
        text +=
            "    material.set_editor_property(\"shading_model\", "
            "unreal.MaterialShadingModel.MSM_CLEAR_COAT)\n";
    return text;
}

constexpr std::string_view unreal_lacks[] = {"specular_weight",
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
                                             "thin_film_weight"};

std::string unreal_readme(const ExportRequest& request) {
    return R"(In the Unreal editor (plugin "Python Editor Script Plugin"): Tools > Execute Python Script, )" +
           request.name + R"(.py.
It imports the maps to /Game/Wrinkle/)" +
           request.name + " and builds the material M_" + request.name + R"(.

The maps are for the uv layout of )" +
           request.mesh_name + R"(. Normals have green down (DirectX), for a mesh with MikkTSpace
tangents. _ORM holds occlusion, roughness and metalness, _C the clear coat, _H the height from its
lowest to its highest value. Back faces of two-sided materials have negated normals.

)" + request.name +
           R"(.ush is the graph's own function, for Custom nodes: images and inputs are its parameters.
Written by the documentation of Unreal Engine 5; it was not tried in Unreal.
)";
}

bool write_unreal_function(const ExportRequest& request, const fs::path& folder,
                           Diagnostics& diagnostics) {
    Target target = *find_target("hlsl");
    target.language = unreal_hlsl;
    ShaderOptions options;
    options.emit.name = request.name;
    options.emit.target = &target;
    options.emit.uv_origin = UvOrigin::top;
    const MadeShader made = make_shader(request.project, request.registry, options, diagnostics);
    return !diagnostics.has_errors() &&
           write_export_file(folder / (request.name + ".ush"),
                             "#pragma once\n" + made.shader.source, diagnostics);
}

}  // namespace

bool write_unreal(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    if (!write_unreal_function(request, folder, diagnostics)) return false;
    const auto baked = bake_outputs(request, diagnostics);
    if (!baked) return false;
    for (const std::string_view output : unreal_lacks)
        if (std::ranges::count(baked->graph_outputs, output))
            warn_unsupported(request, "Unreal", output, diagnostics);
    const std::string parts = UnrealMaps(request, *baked, folder, diagnostics).parts();
    const std::string script =
        with_fields(texts::unreal_py, {{"NAME", request.name},
                                       {"TWO_SIDED", request.double_sided ? "True" : "False"},
                                       {"SETTINGS", unreal_settings(*baked)},
                                       {"PARTS", parts}});
    return !diagnostics.has_errors() &&
           write_export_file(folder / (request.name + ".py"), script, diagnostics) &&
           write_readme(request, "Unreal Engine", unreal_readme(request), folder, diagnostics);
}

}  // namespace wrinkle
