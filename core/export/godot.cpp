// Godot 3 and 4: a spatial shader, a material that fills its parameters, textures, and a project
// that shows them.
#include "export/godot.h"

#include "export/files.h"
#include "export/hosts.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

constexpr GodotVersion godot_3 = {3,
                                  "Godot 3",
                                  "godot3",
                                  ".shader",
                                  "WORLD_MATRIX",
                                  "INV_CAMERA_MATRIX",
                                  "CAMERA_MATRIX",
                                  "depth_draw_alpha_prepass"};
constexpr GodotVersion godot_4 = {4,
                                  "Godot 4",
                                  "godot4",
                                  ".gdshader",
                                  "MODEL_MATRIX",
                                  "VIEW_MATRIX",
                                  "INV_VIEW_MATRIX",
                                  "depth_prepass_alpha"};

// Text of a ShaderMaterial. Paths are relative to the file.
std::string material_text(const GodotVersion& version, const std::string& shader_file,
                          const std::vector<GodotParameter>& parameters,
                          const std::vector<GodotTexture>& textures) {
    const bool three = version.major == 3;
    const auto quoted_id = [&](size_t id) {
        return three ? std::to_string(id) : "\"" + std::to_string(id) + "\"";
    };
    const auto reference = [&](size_t id) {
        return three ? "ExtResource( " + quoted_id(id) + " )"
                     : "ExtResource(" + quoted_id(id) + ")";
    };
    std::map<std::string, size_t> ids = {{shader_file, 1}};
    for (const GodotTexture& texture : textures)
        ids.try_emplace(texture.file, ids.size() + 1);
    std::string text =
        "[gd_resource type=\"ShaderMaterial\" load_steps=" + std::to_string(ids.size() + 1) +
        " format=" + (three ? "2" : "3") + "]\n\n";
    std::map<size_t, std::string> files;
    for (const auto& [file, id] : ids)
        files[id] = file;
    for (const auto& [id, file] : files)
        text += "[ext_resource path=\"" + file + "\" type=\"" +
                (id == 1 ? "Shader" : (three ? "StreamTexture" : "Texture2D")) +
                "\" id=" + quoted_id(id) + "]\n";
    const std::string key = three ? "shader_param/" : "shader_parameter/";
    text += "\n[resource]\nshader = " + reference(1) + "\n";
    for (const GodotParameter& parameter : parameters)
        text += key + parameter.name + " = " + parameter.value + "\n";
    for (const GodotTexture& texture : textures)
        text += key + texture.sampler + " = " + reference(ids[texture.file]) + "\n";
    return text;
}

std::string godot_readme(const ExportRequest& request, const GodotVersion& version) {
    const std::string name = request.name;
    const std::string material = name + "/" + name + "_material.tres";
    std::string text = "To look at it:\n\n";
    if (version.major == 3)
        text += "    godot3 --path .\n\n";
    else
        text +=
            "    godot --path . --editor main.tscn\n\n"
            "The editor imports the files when it opens the folder; F5 runs the scene.\n\n";
    text += "To use it, copy the folder " + name + " into your project and choose\n" + material +
            " as a material. Its shader parameters are the graph's inputs.\n"
            "Paths are relative, so the folder can lie anywhere in the project.\n\n";
    if (version.major == 3)
        text +=
            "The renderer is GLES3. Import meshes with meshes/compress off: compressed uvs turn\n"
            "bumps by degrees. Textures are .stex, Godot's own format: they need no import, and\n"
            "16 bits and floats stay 32-bit floats.\n";
    else
        text +=
            "Import meshes with Force Disable Compression. Written for Godot 4 by its\n"
            "documentation; it was not run there. Godot imports .exr as half precision.\n";
    return text;
}

bool write_godot_host(const ExportRequest& request, const GodotVersion& version,
                      const fs::path& folder, Diagnostics& diagnostics) {
    const auto shader = compile_for_godot(request, version, diagnostics);
    if (!shader) return false;
    warn_of_mesh(request, shader->fragment.reflection, diagnostics);
    const fs::path own = folder / request.name;
    const auto textures =
        write_godot_textures(request, version, shader->samplers, own, diagnostics);
    if (!textures) return false;
    const auto parameters = godot_parameters(request, version, *shader);
    const std::string file = request.name + std::string(version.extension);
    const std::string material = request.name + "_material.tres";
    return write_export_file(own / file,
                             godot_shader_text(request, version, *shader, parameters, *textures),
                             diagnostics) &&
           write_export_file(own / material, material_text(version, file, parameters, *textures),
                             diagnostics) &&
           write_godot_project(request, version, request.name + "/" + material, folder,
                               diagnostics) &&
           write_readme(request, version.label, godot_readme(request, version), folder,
                        diagnostics);
}

}  // namespace

const GodotVersion& godot_version(int major) {
    return major == 3 ? godot_3 : godot_4;
}

bool write_godot3(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    return write_godot_host(request, godot_3, folder, diagnostics);
}

bool write_godot(const ExportRequest& request, const fs::path& folder, Diagnostics& diagnostics) {
    return write_godot_host(request, godot_4, folder, diagnostics);
}

}  // namespace wrinkle
