// Blender 3.4 and later: maps, and a script that builds a Principled BSDF from them and from a
// group of nodes.
#include <algorithm>
#include <cmath>

#include "base/fuzz.h"
#include "base/srgb.h"
#include "base/standard_outputs.h"
#include "base/text.h"
#include "export/baked_material.h"
#include "export/blender_group.h"
#include "export/files.h"
#include "export/host_text.h"
#include "export/host_values.h"
#include "export/hosts.h"
#include "export/preview_camera.h"
#include "export/texts.h"
#include "image/load.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

using Color = std::array<float, 3>;

std::string python_number(double value) {
    return shortest(static_cast<float>(value));
}

// A name of an input in Blender 3.4 and one in 4.x.
struct InputNames {
    std::string_view old_name, new_name;

    std::string tuple() const {
        std::string text = "(\"" + std::string(old_name) + "\"";
        return text + (new_name.empty() ? ",)" : ", \"" + std::string(new_name) + "\")");
    }
};

class BlenderMaterial {
public:
    BlenderMaterial(const ExportRequest& request, const BakedMaterial& baked,
                    const BlenderGroup& group, const fs::path& folder, Diagnostics& diagnostics)
        : request_(request),
          baked_(baked),
          group_(group),
          folder_(folder),
          diagnostics_(diagnostics) {}

    std::string inputs, normals, displacement = "None", occlusion = "None";
    std::string fuzz_albedos;

    void write() {
        if (!add_computed({"Base Color", ""}, "color"))
            add_color({"Base Color", ""}, "color", base_color_outputs(baked_),
                      [&](size_t texel) { return host_base_color(baked_, texel); });
        add({"Metallic", ""}, "metalness");
        roughness();
        specular();
        coat();
        fuzz();
        add({"Transmission", "Transmission Weight"}, "transmission_weight");
        add({"Subsurface", "Subsurface Weight"}, "subsurface_weight");
        if (has("subsurface_color") && !add_computed({"Subsurface Color", ""}, "subsurface_color"))
            add_color({"Subsurface Color", ""}, "subsurface_color", {"subsurface_color"},
                      [&](size_t texel) { return baked_.at("subsurface_color", texel); });
        emission();
        add({"Alpha", ""}, "opacity");
        add_normal_map({"Normal", ""}, "normal");
        add_normal_map({"Clearcoat Normal", "Coat Normal"}, "coat_normal");
        if (has("occlusion")) {
            const Image image = composed(baked_, 1, [&](size_t texel) {
                return std::array<float, 4>{value("occlusion", texel), 0, 0, 0};
            });
            occlusion = "\"" + save("occlusion", image, PixelType::u16) + "\"";
        }
        displace();
    }

private:
    using Names = std::initializer_list<std::string_view>;

    float value(std::string_view output, size_t texel = 0) const {
        return baked_.at(output, texel)[0];
    }
    bool has(std::string_view output) const { return baked_.find(output) != nullptr; }

    void add_line(const InputNames& names, const std::string& value) {
        inputs += "    (" + names.tuple() + ", " + value + "),\n";
    }

    // Returns the name of the file, below the folder of the export.
    std::string save(const std::string& map, const Image& image, PixelType type) {
        const char* extension = type == PixelType::float32 ? ".exr" : ".png";
        std::string stem = "textures/" + request_.name + "_" + map;
        while (group_.files.contains(stem + extension))
            stem += "_baked";
        const std::string file = stem + extension;
        WriterOptions options;
        options.type = type;
        std::error_code error;
        fs::create_directories(folder_ / "textures", error);
        if (error)
            report_unwritable(folder_ / "textures", error, diagnostics_);
        else
            save_image(image, folder_ / file, options, diagnostics_);
        return file;
    }

    static std::string image_text(const std::string& file, const char* space) {
        return "{\"image\": \"" + file + "\", \"space\": \"" + space + "\"}";
    }

    // Returns false if no node computes the output.
    bool add_computed(const InputNames& names, const std::string& output) {
        if (!group_.outputs.contains(output)) return false;
        add_line(names, "{\"output\": \"" + output + "\"}");
        return true;
    }

    // A number if the outputs are constant, else a map of 16 bits.
    void add_number(const InputNames& names, const std::string& map, Names outputs,
                    const std::function<float(size_t)>& of) {
        if (baked_.all_constant(outputs)) return add_line(names, python_number(of(0)));
        const Image image = composed(baked_, 1, [&](size_t texel) {
            return std::array<float, 4>{of(texel), 0, 0, 0};
        });
        add_line(names, image_text(save(map, image, PixelType::u16), "Non-Color"));
    }

    void add(const InputNames& names, const std::string& output) {
        if (has(output) && !add_computed(names, output))
            add_number(names, output, {output}, [&](size_t texel) { return value(output, texel); });
    }

    void add_color(const InputNames& names, const std::string& map, Names outputs,
                   const std::function<Color(size_t)>& of) {
        if (baked_.all_constant(outputs)) {
            const Color color = of(0);
            return add_line(names, "(" + python_number(color[0]) + ", " + python_number(color[1]) +
                                       ", " + python_number(color[2]) + ")");
        }
        const Image image = composed(baked_, 3, [&](size_t texel) {
            std::array<float, 4> coded{};
            const Color color = of(texel);
            for (size_t i = 0; i < 3; ++i)
                coded[i] = static_cast<float>(srgb_from_linear(std::clamp(color[i], 0.0F, 1.0F)));
            return coded;
        });
        add_line(names, image_text(save(map, image, PixelType::u16), "sRGB"));
    }

    // Cycles' lobe has the roughness r^2 / q along the tangent and r^2 q across, q^2 = 1 - 0.9 a.
    void roughness() {
        const auto across = [&](size_t texel) {
            return 1 - std::clamp(value("specular_roughness_anisotropy", texel), 0.0F, 0.999F);
        };
        if (add_computed({"Roughness", ""}, "roughness")) return;
        add_number({"Roughness", ""}, "roughness", {"roughness", "specular_roughness_anisotropy"},
                   [&](size_t texel) {
                       const float s = across(texel);
                       const float scale = std::pow(2 * s / (1 + s * s), 0.25F);
                       return std::min(value("roughness", texel) * scale, 1.0F);
                   });
        if (has("specular_roughness_anisotropy"))
            add_number({"Anisotropic", ""}, "anisotropy", {"specular_roughness_anisotropy"},
                       [&](size_t texel) { return std::min((1 - across(texel)) / 0.9F, 1.0F); });
    }

    // Blender 3.4 takes the reflectance over 0.08, 4.x the index and a factor, 0.5 for 1.
    void specular() {
        if (!has("specular_weight") && !has("specular_ior")) return;
        add_number({"Specular", ""}, "specular", {"specular_weight", "specular_ior"},
                   [&](size_t texel) {
                       const float ior = value("specular_ior", texel);
                       const float ratio = (ior - 1) / (ior + 1);
                       return value("specular_weight", texel) * ratio * ratio / 0.08F;
                   });
        add_number({"IOR", ""}, "ior", {"specular_ior"},
                   [&](size_t texel) { return value("specular_ior", texel); });
        if (has("specular_weight"))
            add_number({"Specular IOR Level", ""}, "specular_level", {"specular_weight"},
                       [&](size_t texel) { return value("specular_weight", texel) / 2; });
    }

    void coat() {
        if (!has("coat_weight")) return;
        add_number({"Clearcoat", "Coat Weight"}, "coat_weight", {"coat_weight", "coat_ior"},
                   [&](size_t texel) { return host_coat_weight(baked_, texel); });
        add_number({"Clearcoat Roughness", "Coat Roughness"}, "coat_roughness", {"coat_roughness"},
                   [&](size_t texel) { return value("coat_roughness", texel); });
    }

    // Blender 4.x has the lobe; 3.4 gets its albedo at steps of 1 - cosine.
    void fuzz() {
        if (!has("fuzz_weight")) return;
        add_number({"Sheen Weight", ""}, "fuzz_weight", {"fuzz_weight"},
                   [&](size_t texel) { return value("fuzz_weight", texel); });
        add_line({"Sheen Roughness", ""}, python_number(value("fuzz_roughness")));
        add_color({"Sheen Tint", ""}, "fuzz_color", {"fuzz_color"},
                  [&](size_t texel) { return baked_.at("fuzz_color", texel); });
        constexpr int steps = 16;
        for (int i = 0; i <= steps; ++i) {
            const double facing = static_cast<double>(i) / steps;
            append_item(fuzz_albedos,
                        "(" + python_number(facing) + ", " +
                            python_number(fuzz_albedo(1 - facing, value("fuzz_roughness"))) + ")");
        }
    }

    // Colors of the map are at most 1; the rest is the strength.
    void emission() {
        if (!emits(baked_)) return;
        float greatest = 0;
        for (size_t texel = 0; texel < size_t{baked_.width} * baked_.height; ++texel)
            for (const float channel : host_emission(baked_, texel))
                greatest = std::max(greatest, channel);
        if (greatest == 0) return;
        add_color({"Emission", "Emission Color"}, "emission", {"emission", "emission_luminance"},
                  [&](size_t texel) {
                      Color color = host_emission(baked_, texel);
                      for (float& channel : color)
                          channel /= greatest;
                      return color;
                  });
        add_line({"Emission Strength", ""}, python_number(greatest));
    }

    void add_normal_map(const InputNames& names, const std::string& output) {
        if (!has(output)) return;
        const Image image = composed(baked_, 3, [&](size_t texel) {
            const Color m = baked_.at(output, texel);
            return std::array<float, 4>{(m[0] + 1) / 2, (m[1] + 1) / 2, (m[2] + 1) / 2, 1};
        });
        normals +=
            "    (" + names.tuple() + ", \"" + save(output, image, PixelType::u16) + "\"),\n";
    }

    void displace() {
        if (!has("displacement")) return;
        const Image image = composed(baked_, 3, [&](size_t texel) {
            const float height = value("displacement", texel);
            return std::array<float, 4>{height, height, height, 1};
        });
        displacement = "\"" + save("displacement", image, PixelType::float32) + "\"";
    }

    const ExportRequest& request_;
    const BakedMaterial& baked_;
    const BlenderGroup& group_;
    const fs::path& folder_;
    Diagnostics& diagnostics_;
};

constexpr std::string_view blender_lacks[] = {"base_diffuse_roughness",
                                              "specular_color",
                                              "tangent",
                                              "coat_roughness_anisotropy",
                                              "coat_tangent",
                                              "subsurface_radius",
                                              "subsurface_radius_scale",
                                              "subsurface_scatter_anisotropy",
                                              "transmission_color",
                                              "transmission_depth",
                                              "transmission_scatter",
                                              "transmission_scatter_anisotropy",
                                              "transmission_dispersion_scale",
                                              "transmission_dispersion_abbe_number",
                                              "thin_film_weight",
                                              "thin_film_thickness",
                                              "thin_film_ior",
                                              "thin_walled"};

void warn_of_back_faces(const ExportRequest& request, const BakedMaterial& baked,
                        Diagnostics& diagnostics) {
    const BackFaces rule = request.project.files[0].document.back_face_rule();
    if (!request.double_sided || !baked.find("normal") || rule == BackFaces::flip) return;
    diagnostics.add(
        file_problem(Severity::warning, RuleId::host_lacks, request.graph,
                     "Blender negates the normals of back faces, the rule 'flip', not '" +
                         std::string(back_faces_names[static_cast<size_t>(rule)]) + "'",
                     "bumps of back faces are dents there"));
}

// The mesh with the uv set of the maps, as OBJ: Blender's importer reads its normals.
std::string obj_text(const Mesh& mesh) {
    std::string text;
    const auto add = [&](const char* key, const float* values, int count) {
        text += key;
        for (int i = 0; i < count; ++i)
            text += " " + shortest(values[i]);
        text += "\n";
    };
    for (const glm::vec3& position : mesh.positions)
        add("v", &position.x, 3);
    for (const glm::vec2& uv : mesh.uvs[0])
        add("vt", &uv.x, 2);
    for (const glm::vec3& normal : mesh.normals)
        add("vn", &normal.x, 3);
    text += "s 1\n";  // Cycles takes its tangents from flat faces otherwise
    for (size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::string corner = std::to_string(mesh.indices[i] + 1);
        text += (i % 3 == 0 ? "f " : " ") + corner + "/" + corner + "/" + corner;
        if (i % 3 == 2) text += "\n";
    }
    return text;
}

// A matrix from the camera to the world, with Blender's z upwards: (x, -z, y).
std::string camera_matrix(const Mesh& mesh) {
    const PreviewCamera camera = preview_camera(mesh);
    const glm::dvec3 columns[] = {camera.right, camera.up, camera.back, camera.eye};
    std::string text = "(";
    for (const int row : {0, 2, 1}) {
        text += "(";
        for (const glm::dvec3& column : columns)
            text += python_number(row == 2 ? -column[row] : column[row]) + ", ";
        text += "), ";
    }
    return text + "(0, 0, 0, 1))";
}

std::string blender_readme(const ExportRequest& request, const BlenderGroup& group) {
    std::string text;
    if (!group.outputs.empty())
        text += "The node group " + request.name + " computes " + joined(group.outputs, ", ") +
                ", for any resolution and any mesh.\n";
    if (!group.input_labels.empty())
        text += "Its inputs are " + joined(group.input_labels, ", ") + ".\n";
    if (!text.empty()) text += "\n";
    return text + "To look at it:\n\n    blender --background --python-exit-code 1 --python " +
           request.name +
           ".py -- --render preview.png\n\n"
           "To use it, open " +
           request.name +
           ".py in the Text editor of Blender and run it: the material goes to the\n"
           "active object. Or save a file to append it from: --save " +
           request.name +
           ".blend instead of --render.\n"
           "The maps are baked for the uv layout of mesh.obj (" +
           request.mesh_name +
           "); other meshes need the same layout.\n\n"
           "Colors are sRGB, all other maps linear (Non-Color), in 16 bits; normals have green "
           "up.\n"
           "Back faces: Blender negates the bumped normal, so bumps are dents there.\n"
           "Tested with Blender 3.4.1; the inputs of 4.x are found by their names there.\n";
}

}  // namespace

bool write_blender(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    const auto baked = bake_outputs(request, diagnostics);
    if (!baked) return false;
    for (const std::string_view output : blender_lacks)
        if (std::ranges::count(baked->graph_outputs, output))
            warn_unsupported(request, "Blender", output, diagnostics);
    warn_of_back_faces(request, *baked, diagnostics);
    const BlenderGroup group = blender_group(request, *baked, folder, diagnostics);
    if (diagnostics.has_errors()) return false;
    BlenderMaterial material(request, *baked, group, folder, diagnostics);
    material.write();
    const auto python_bool = [](bool value) { return std::string(value ? "True" : "False"); };
    const std::string script = with_fields(
        texts::blender_py,
        {{"NAME", request.name},
         {"GROUP_INPUTS", group.inputs_text},
         {"GROUP_NODES", group.nodes_text},
         {"GROUP_OUTPUTS", group.outputs_text},
         {"INPUTS", material.inputs},
         {"NORMALS", material.normals},
         {"DISPLACEMENT", material.displacement},
         {"OCCLUSION", material.occlusion},
         {"FUZZ", material.fuzz_albedos},
         {"ALONG_U", python_bool(baked->find("specular_roughness_anisotropy") != nullptr)},
         {"OPACITY", python_bool(baked->find("opacity") != nullptr)},
         {"CAMERA", camera_matrix(request.mesh)},
         {"FIELD_OF_VIEW", python_number(preview_field_of_view)}});
    return !diagnostics.has_errors() &&
           write_export_file(folder / (request.name + ".py"), script, diagnostics) &&
           write_export_file(folder / "mesh.obj", obj_text(request.mesh), diagnostics) &&
           write_readme(request, "Blender", blender_readme(request, group), folder, diagnostics);
}

}  // namespace wrinkle
