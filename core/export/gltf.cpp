// glTF 2.0: one GLB with the mesh, its maps and the Khronos material extensions.
//
// A property is a factor if its outputs are constant over the mesh, else a texture: colors in 8
// bits of sRGB, the normal in 16 bits, other data in 8 bits.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/file.h"
#include "base/srgb.h"
#include "base/standard_outputs.h"
#include "export/baked_material.h"
#include "export/files.h"
#include "export/glb.h"
#include "export/host_values.h"
#include "export/hosts.h"
#include "image/load.h"
#include "json/write.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

using json::Value;
using Texel = std::array<float, 4>;
using Names = std::initializer_list<std::string_view>;

Value number_of(float value) {
    return Value::single(value);
}

Value numbers_of(std::span<const float> values) {
    std::vector<Value> list;
    for (const float value : values)
        list.push_back(number_of(value));
    return Value::array(list);
}

Texel srgb_texel(const std::array<float, 3>& color, float alpha = 1) {
    Texel texel{0, 0, 0, alpha};
    for (size_t i = 0; i < 3; ++i)
        texel[i] = static_cast<float>(srgb_from_linear(std::clamp(color[i], 0.0F, 1.0F)));
    return texel;
}

class GltfMaterial {
public:
    GltfMaterial(const ExportRequest& request, const BakedMaterial& baked, const fs::path& folder,
                 Glb& glb, Diagnostics& diagnostics)
        : request_(request), baked_(baked), folder_(folder), glb_(glb), diagnostics_(diagnostics) {}

    JsonMembers members() {
        root_.emplace_back("name", Value::string(request_.name));
        base();
        normals();
        emission();
        alpha();
        specular();
        anisotropy();
        coat();
        transmission();
        fuzz();
        thin_film();
        if (!extensions_.empty()) root_.emplace_back("extensions", Value::object(extensions_));
        return root_;
    }

    std::vector<std::string> extension_names() const {
        std::vector<std::string> names;
        for (const auto& extension : extensions_)
            names.push_back(extension.first);
        return names;
    }

private:
    float value(std::string_view output, size_t texel = 0) const {
        return baked_.at(output, texel)[0];
    }
    bool has(Names outputs) const {
        return std::ranges::any_of(outputs, [&](auto name) { return baked_.find(name); });
    }

    // Adds "NAMETexture" of the image.
    void add_texture(JsonMembers& to, const std::string& name, uint32_t channels, PixelType type,
                     const std::function<Texel(size_t)>& texel, JsonMembers info = {}) {
        const std::string file = request_.name + "_" + name;
        const fs::path path = folder_ / (file + ".png");
        Image image = composed(baked_, channels, texel);
        image.has_alpha = channels == 4;
        WriterOptions options;
        options.type = type;
        if (!save_image(image, path, options, diagnostics_)) return;
        std::string why;
        const auto png = read_file(path, ~uint64_t{0}, why);
        std::error_code ignored;
        fs::remove(path, ignored);
        info.insert(info.begin(), {"index", json_index(glb_.add_texture(file, png.value_or("")))});
        to.emplace_back(name + "Texture", Value::object(info));
    }

    // Adds a factor if the outputs are constant, else a texture with the value in one channel.
    void add_number(JsonMembers& to, const std::string& name, uint32_t channel, Names outputs,
                    const std::function<float(size_t)>& of) {
        const bool constant = baked_.all_constant(outputs);
        to.emplace_back(name + "Factor", number_of(constant ? of(0) : 1));
        if (constant) return;
        add_texture(to, name, std::max(channel + 1, 3U), PixelType::u8, [&](size_t texel) {
            Texel made{0, 0, 0, 0};
            made[channel] = of(texel);
            return made;
        });
    }

    void base() {
        JsonMembers pbr;
        const bool constant =
            baked_.all_constant(base_color_outputs(baked_)) && baked_.all_constant({"opacity"});
        if (constant) {
            const auto color = host_base_color(baked_, 0);
            const float factor[] = {color[0], color[1], color[2], value("opacity")};
            pbr.emplace_back("baseColorFactor", numbers_of(factor));
        } else {
            const uint32_t channels = has({"opacity"}) ? 4 : 3;
            add_texture(pbr, "baseColor", channels, PixelType::u8, [&](size_t texel) {
                return srgb_texel(host_base_color(baked_, texel), value("opacity", texel));
            });
        }
        roughness(pbr);
        root_.emplace_back("pbrMetallicRoughness", Value::object(pbr));
        occlusion();
    }

    bool constant_roughness() const {
        return baked_.all_constant(
            {"roughness", "metalness", "specular_roughness_anisotropy", "occlusion"});
    }

    // One image holds occlusion, roughness and metalness.
    void roughness(JsonMembers& pbr) {
        if (constant_roughness()) {
            pbr.emplace_back("roughnessFactor", number_of(host_roughness(baked_, 0).roughness));
            pbr.emplace_back("metallicFactor", number_of(value("metalness")));
            return;
        }
        add_texture(pbr, "metallicRoughness", 3, PixelType::u8, [&](size_t texel) {
            return Texel{value("occlusion", texel), host_roughness(baked_, texel).roughness,
                         value("metalness", texel), 1};
        });
    }

    void occlusion() {
        if (!has({"occlusion"})) return;
        if (constant_roughness()) {
            add_texture(root_, "occlusion", 3, PixelType::u8, [&](size_t texel) {
                return Texel{value("occlusion", texel), 1, 1, 1};
            });
            return;
        }
        const Value shared = root_.back().second.find("metallicRoughnessTexture");
        root_.emplace_back("occlusionTexture", shared);
    }

    void normal_map(JsonMembers& to, const std::string& name, std::string_view output) {
        const BakedOutput* normal = baked_.find(output);
        constexpr std::array<float, 3> up = {0, 0, 1};
        if (!normal || (normal->constant && normal->value == up)) return;
        add_texture(to, name, 3, PixelType::u16, [&](size_t texel) {
            const auto m = baked_.at(output, texel);
            return Texel{(m[0] + 1) / 2, (m[1] + 1) / 2, (m[2] + 1) / 2, 1};
        });
    }

    void normals() {
        normal_map(root_, "normal", "normal");
        if (!request_.double_sided) return;
        root_.emplace_back("doubleSided", Value::boolean(true));
        const BackFaces rule = request_.project.files[0].document.back_face_rule();
        if (baked_.find("normal") && rule != BackFaces::flip)
            diagnostics_.add(
                file_problem(Severity::warning, RuleId::host_lacks, request_.graph,
                             "glTF negates the normals of back faces, the rule 'flip', not '" +
                                 std::string(back_faces_names[static_cast<size_t>(rule)]) + "'",
                             "bumps of back faces are dents there"));
    }

    // Factors are at most 1; the rest is a strength.
    void emission() {
        if (!emits(baked_)) return;
        float greatest = 0;
        for (size_t texel = 0; texel < size_t{baked_.width} * baked_.height; ++texel)
            for (const float channel : host_emission(baked_, texel))
                greatest = std::max(greatest, channel);
        if (greatest == 0) return;
        const auto scaled = [&](size_t texel) {
            auto color = host_emission(baked_, texel);
            for (float& channel : color)
                channel /= greatest;
            return color;
        };
        const bool constant = baked_.all_constant({"emission", "emission_luminance"});
        root_.emplace_back("emissiveFactor",
                           numbers_of(constant ? scaled(0) : std::array<float, 3>{1, 1, 1}));
        if (!constant)
            add_texture(root_, "emissive", 3, PixelType::u8,
                        [&](size_t texel) { return srgb_texel(scaled(texel)); });
        extensions_.emplace_back(
            "KHR_materials_emissive_strength",
            Value::object(JsonMembers{{"emissiveStrength", number_of(greatest)}}));
    }

    // MASK if nearly all texels are absent or present.
    void alpha() {
        const BakedOutput* opacity = baked_.find("opacity");
        if (!opacity || (opacity->constant && opacity->value[0] >= 1)) return;
        const auto between =
            std::ranges::count_if(opacity->texels, [](float a) { return a > 0.02F && a < 0.98F; });
        const bool mask = static_cast<size_t>(between) * 20 < opacity->texels.size();
        root_.emplace_back("alphaMode", Value::string(mask ? "MASK" : "BLEND"));
    }

    void add_extension(const std::string& name, const JsonMembers& members) {
        extensions_.emplace_back("KHR_materials_" + name, Value::object(members));
    }

    void specular() {
        if (has({"specular_ior"})) add_extension("ior", {{"ior", number_of(mean("specular_ior"))}});
        if (!has({"specular_weight", "specular_color"})) return;
        JsonMembers made;
        add_number(made, "specular", 3, {"specular_weight"},
                   [&](size_t texel) { return value("specular_weight", texel); });
        if (baked_.all_constant({"specular_color"}))
            made.emplace_back("specularColorFactor", numbers_of(baked_.at("specular_color", 0)));
        else
            add_texture(made, "specularColor", 3, PixelType::u8, [&](size_t texel) {
                return srgb_texel(baked_.at("specular_color", texel));
            });
        add_extension("specular", made);
    }

    // Along the tangent of the mesh: red and green hold the direction (1, 0).
    void anisotropy() {
        if (!has({"specular_roughness_anisotropy"})) return;
        const bool constant = baked_.all_constant({"specular_roughness_anisotropy", "roughness"});
        JsonMembers made = {
            {"anisotropyStrength", number_of(constant ? host_roughness(baked_, 0).strength : 1)}};
        if (!constant)
            add_texture(made, "anisotropy", 3, PixelType::u8, [&](size_t texel) {
                return Texel{1, 0.5F, host_roughness(baked_, texel).strength, 1};
            });
        add_extension("anisotropy", made);
    }

    void coat() {
        if (!has({"coat_weight"})) return;
        JsonMembers made;
        add_number(made, "clearcoat", 0, {"coat_weight", "coat_ior"},
                   [&](size_t texel) { return host_coat_weight(baked_, texel); });
        add_number(made, "clearcoatRoughness", 1, {"coat_roughness"},
                   [&](size_t texel) { return value("coat_roughness", texel); });
        normal_map(made, "clearcoatNormal", "coat_normal");
        add_extension("clearcoat", made);
    }

    void transmission() {
        if (!has({"transmission_weight"})) return;
        JsonMembers made;
        add_number(made, "transmission", 0, {"transmission_weight"},
                   [&](size_t texel) { return value("transmission_weight", texel); });
        add_extension("transmission", made);
        const float depth = mean("transmission_depth");
        const bool thin = has({"thin_walled"}) && mean("thin_walled") > 0.5F;
        if (thin || depth <= 0) return;
        add_extension("volume",
                      {{"thicknessFactor", number_of(depth)},
                       {"attenuationDistance", number_of(depth)},
                       {"attenuationColor", numbers_of(baked_.at("transmission_color", 0))}});
        if (has({"transmission_dispersion_scale"}))
            add_extension("dispersion",
                          {{"dispersion", number_of(mean("transmission_dispersion_scale") * 20 /
                                                    mean("transmission_dispersion_abbe_number"))}});
    }

    void fuzz() {
        if (!has({"fuzz_weight"})) return;
        const auto color = [&](size_t texel) {
            auto made = baked_.at("fuzz_color", texel);
            for (float& channel : made)
                channel *= value("fuzz_weight", texel);
            return made;
        };
        const bool constant = baked_.all_constant({"fuzz_weight", "fuzz_color"});
        JsonMembers made = {
            {"sheenColorFactor", numbers_of(constant ? color(0) : std::array<float, 3>{1, 1, 1})}};
        if (!constant)
            add_texture(made, "sheenColor", 3, PixelType::u8,
                        [&](size_t texel) { return srgb_texel(color(texel)); });
        add_number(made, "sheenRoughness", 3, {"fuzz_roughness"},
                   [&](size_t texel) { return host_fuzz_roughness(baked_, texel); });
        add_extension("sheen", made);
    }

    // Thickness in micrometers, in nanometers there.
    void thin_film() {
        if (!has({"thin_film_weight"})) return;
        constexpr float nm = 1000;
        float thickest = 0;
        for (size_t texel = 0; texel < size_t{baked_.width} * baked_.height; ++texel)
            thickest = std::max(thickest, value("thin_film_thickness", texel) * nm);
        JsonMembers made = {{"iridescenceIor", number_of(mean("thin_film_ior"))},
                            {"iridescenceThicknessMinimum", number_of(0)},
                            {"iridescenceThicknessMaximum", number_of(thickest)}};
        add_number(made, "iridescence", 0, {"thin_film_weight"},
                   [&](size_t texel) { return value("thin_film_weight", texel); });
        if (thickest > 0 && !baked_.all_constant({"thin_film_thickness"}))
            add_texture(made, "iridescenceThickness", 3, PixelType::u8, [&](size_t texel) {
                return Texel{0, value("thin_film_thickness", texel) * nm / thickest, 0, 1};
            });
        add_extension("iridescence", made);
    }

    // The value of a property that glTF holds once for a material; a warning if it varies.
    float mean(std::string_view output) {
        if (baked_.all_constant({output})) return value(output);
        double sum = 0;
        const size_t texels = size_t{baked_.width} * baked_.height;
        for (size_t texel = 0; texel < texels; ++texel)
            sum += value(output, texel);
        diagnostics_.add(file_problem(Severity::warning, RuleId::host_lacks, request_.graph,
                                      "glTF holds one value of '" + std::string(output) +
                                          "' for a material; the mean is taken",
                                      "it varies over the mesh"));
        return static_cast<float>(sum / static_cast<double>(texels));
    }

    const ExportRequest& request_;
    const BakedMaterial& baked_;
    const fs::path& folder_;
    Glb& glb_;
    Diagnostics& diagnostics_;
    JsonMembers root_, extensions_;
};

constexpr std::string_view gltf_lacks[] = {"displacement",
                                           "base_diffuse_roughness",
                                           "tangent",
                                           "coat_roughness_anisotropy",
                                           "coat_tangent",
                                           "subsurface_weight",
                                           "transmission_scatter"};

// Maps use only uv0, and tangents if one of them is a normal.
Mesh mesh_of_maps(Mesh mesh, const JsonMembers& material) {
    for (size_t set = 1; set < max_uv_sets; ++set)
        mesh.uvs[set].clear();
    const std::string text = json::one_line(Value::object(material));
    if (text.find("normalTexture") == text.npos && text.find("anisotropy") == text.npos &&
        text.find("clearcoatNormalTexture") == text.npos)
        mesh.tangents.clear();
    return mesh;
}

std::string gltf_readme(const ExportRequest& request) {
    return request.name + R"(.glb holds the mesh, its tangents (MikkTSpace) and the material's maps.
Open it in any glTF 2.0 viewer, or drag it into https://gltf-viewer.donmccurdy.com, Blender
(File > Import > glTF), Godot, Unity or Unreal.

The mesh has its first uv set, which the maps are baked for. Colors are sRGB, all others linear;
normals have green up (OpenGL) and 16 bits; occlusion, roughness and metalness are red, green and
blue of one image. Viewers that cut the normal map to 8 bits, as browsers do, are up to 0.3 degrees
off.
)";
}

}  // namespace

bool write_gltf(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    const auto baked = bake_outputs(request, diagnostics);
    if (!baked) return false;
    for (const std::string_view output : gltf_lacks)
        if (std::ranges::count(baked->graph_outputs, output))
            warn_unsupported(request, "glTF", output, diagnostics);
    Glb glb;
    GltfMaterial material(request, *baked, folder, glb, diagnostics);
    const JsonMembers members = material.members();
    if (diagnostics.has_errors()) return false;
    const std::string file = glb.bytes(mesh_of_maps(request.mesh, members), request.name, members,
                                       material.extension_names());
    return write_export_file(folder / (request.name + ".glb"), file, diagnostics) &&
           write_readme(request, "glTF 2.0", gltf_readme(request), folder, diagnostics);
}

}  // namespace wrinkle
