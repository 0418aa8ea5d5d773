// A project of Godot that shows a material: the mesh, a camera, a light and a sky.
//
// Godot 3 gets the mesh as an ArrayMesh in 32-bit floats (scene/resources/mesh.cpp); its importer
// would cut uvs to half precision. Godot 4 imports a .glb.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "base/text.h"
#include "export/files.h"
#include "export/glb.h"
#include "export/godot.h"
#include "export/preview_camera.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

std::string number(double value) {
    return shortest(static_cast<float>(value));
}

std::string byte_list(std::string_view bytes) {
    std::string text = "PoolByteArray(";
    text.reserve(bytes.size() * 4);
    for (size_t i = 0; i < bytes.size(); ++i) {
        text += i == 0 ? " " : ", ";
        text += std::to_string(static_cast<uint8_t>(bytes[i]));
    }
    return text + " )";
}

template <class Value>
void append_value(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

// Vertices of Godot 3, interleaved; v points down.
class ArrayMesh {
public:
    explicit ArrayMesh(const Mesh& mesh) : mesh_(mesh) {}

    std::string text() const {
        const Bounds bounds = bounds_of(mesh_);
        const glm::vec3 size = bounds.high - bounds.low;
        std::string box;
        for (const glm::vec3& corner : {bounds.low, size})
            for (int i = 0; i < 3; ++i)
                box += (box.empty() ? " " : ", ") + number(corner[i]);
        return "[gd_resource type=\"ArrayMesh\" format=2]\n\n[resource]\nsurfaces/0 = {\n\"aabb\": "
               "AABB(" +
               box + " ),\n\"array_data\": " + byte_list(vertices()) +
               ",\n\"array_index_data\": " + byte_list(indices()) +
               ",\n\"blend_shape_data\": [  ],\n\"format\": " + std::to_string(format()) +
               ",\n\"index_count\": " + std::to_string(mesh_.indices.size()) +
               ",\n\"primitive\": 4,\n\"skeleton_aabb\": [  ],\n\"vertex_count\": " +
               std::to_string(mesh_.vertex_count()) + "\n}\n";
    }

private:
    uint32_t format() const {
        uint32_t format = 1 | 2 | 256;  // positions, normals, indices
        if (!mesh_.tangents.empty()) format |= 4;
        if (!mesh_.colors.empty()) format |= 8;
        if (mesh_.has_uv(0)) format |= 16;
        if (mesh_.has_uv(1)) format |= 32;
        return format;
    }

    std::string vertices() const {
        std::string bytes;
        for (size_t i = 0; i < mesh_.vertex_count(); ++i) {
            append_value(bytes, mesh_.positions[i]);
            append_value(bytes, mesh_.normals[i]);
            if (!mesh_.tangents.empty()) append_value(bytes, mesh_.tangents[i]);
            if (!mesh_.colors.empty()) append_value(bytes, mesh_.colors[i]);
            for (size_t set = 0; set < 2; ++set)
                if (mesh_.has_uv(set))
                    append_value(bytes, glm::vec2(mesh_.uvs[set][i].x, 1 - mesh_.uvs[set][i].y));
        }
        return bytes;
    }

    // Front faces are clockwise.
    std::string indices() const {
        std::string bytes;
        const bool narrow = mesh_.vertex_count() < 65536;
        for (size_t i = 0; i < mesh_.indices.size(); ++i) {
            const size_t corner = i % 3;
            const uint32_t index = mesh_.indices[i - corner + (3 - corner) % 3];
            if (narrow)
                append_value(bytes, static_cast<uint16_t>(index));
            else
                append_value(bytes, index);
        }
        return bytes;
    }

    const Mesh& mesh_;
};

std::string camera_transform(const Mesh& mesh) {
    const PreviewCamera camera = preview_camera(mesh);
    std::string text;
    for (int row = 0; row < 3; ++row)
        for (const glm::dvec3& axis : {camera.right, camera.up, camera.back})
            text += number(axis[row]) + ", ";
    return text + number(camera.eye.x) + ", " + number(camera.eye.y) + ", " + number(camera.eye.z);
}

// The text of main.tscn: format 2 of Godot 3, format 3 of Godot 4.
class Scene {
public:
    Scene(const ExportRequest& request, const GodotVersion& version)
        : request_(request), three_(version.major == 3) {}

    std::string text(const std::string& material) const {
        return resources(material) + mesh() + camera_and_light() +
               "[node name=\"Environment\" type=\"WorldEnvironment\" parent=\".\"]\nenvironment "
               "= " +
               use("SubResource", 2) + "\n" + (three_ ? "" : "\n[editable path=\"Mesh\"]\n");
    }

private:
    std::string id(int number) const {
        return three_ ? std::to_string(number) : "\"" + std::to_string(number) + "\"";
    }
    std::string use(const char* kind, int number) const {
        return std::string(kind) + (three_ ? "( " + id(number) + " )" : "(" + id(number) + ")");
    }
    std::string node(const std::string& name, const std::string& type) const {
        return "[node name=\"" + name + "\" type=\"" + type + (three_ ? "" : "3D") +
               "\" parent=\".\"]\n";
    }
    std::string transform(const std::string& numbers) const {
        return std::string("transform = ") + (three_ ? "Transform( " : "Transform3D(") + numbers +
               (three_ ? " )" : ")");
    }

    std::string resources(const std::string& material) const {
        std::string text =
            std::string("[gd_scene load_steps=5 format=") + (three_ ? "2" : "3") + "]\n\n";
        text += "[ext_resource path=\"" + material + "\" type=\"Material\" id=" + id(1) + "]\n";
        text += three_ ? "[ext_resource path=\"mesh.tres\" type=\"ArrayMesh\" id=2]\n\n"
                       : "[ext_resource path=\"mesh.glb\" type=\"PackedScene\" id=\"2\"]\n\n";
        text += std::string("[sub_resource type=\"") +
                (three_ ? "ProceduralSky\" id=1]\n\n"
                        : "ProceduralSkyMaterial\" id=\"1\"]\n\n[sub_resource type=\"Sky\" "
                          "id=\"3\"]\nsky_material = SubResource(\"1\")\n\n");
        text += "[sub_resource type=\"Environment\" id=" + id(2) + "]\nbackground_mode = 2\n" +
                (three_ ? "background_sky = SubResource( 1 )\n"
                        : "sky = SubResource(\"3\")\nambient_light_source = 3\n"
                          "reflected_light_source = 2\n") +
                "tonemap_mode = 2\n\n";
        return text + "[node name=\"Main\" type=\"" + (three_ ? "Spatial" : "Node3D") + "\"]\n\n";
    }

    std::string mesh() const {
        if (three_)
            return node("Mesh", "MeshInstance") + "mesh = " + use("ExtResource", 2) +
                   "\nmaterial/0 = " + use("ExtResource", 1) + "\n\n";
        return "[node name=\"Mesh\" parent=\".\" instance=ExtResource(\"2\")]\n\n"
               "[node name=\"" +
               request_.name +
               "\" parent=\"Mesh\" index=\"0\"]\nmaterial_override = " + use("ExtResource", 1) +
               "\n\n";
    }

    std::string camera_and_light() const {
        const std::string degrees = number(preview_field_of_view * 180 / 3.14159265358979);
        return node("Camera", "Camera") + transform(camera_transform(request_.mesh)) +
               "\ncurrent = true\nfov = " + degrees + "\n\n" + node("Light", "DirectionalLight") +
               transform("0.768, 0.427, -0.477, 0, 0.744, 0.667, 0.64, -0.512, 0.572, 0, 0, 0") +
               "\nshadow_enabled = true\n\n";
    }

    const ExportRequest& request_;
    const bool three_;
};

std::string project_text(const ExportRequest& request, const GodotVersion& version) {
    const bool three = version.major == 3;
    std::string text = std::string("config_version=") + (three ? "4" : "5") +
                       "\n\n[application]\n\nconfig/name=\"" + request.name +
                       "\"\nrun/main_scene=\"res://main.tscn\"\n";
    if (!three) return text + "config/features=PackedStringArray(\"4.2\")\n";
    return text +
           "\n[rendering]\n\nquality/driver/driver_name=\"GLES3\"\n"
           "quality/driver/fallback_to_gles2=false\nquality/filters/msaa=2\n";
}

constexpr std::string_view glb_import = R"([remap]

importer="scene"
importer_version=1
type="PackedScene"

[params]

meshes/ensure_tangents=true
meshes/generate_lods=false
meshes/create_shadow_meshes=false
meshes/force_disable_compression=true
)";

bool write_mesh(const ExportRequest& request, const GodotVersion& version, const fs::path& folder,
                Diagnostics& diagnostics) {
    if (version.major == 3)
        return write_export_file(folder / "mesh.tres", ArrayMesh(request.mesh).text(), diagnostics);
    return write_export_file(folder / "mesh.glb", Glb().bytes(request.mesh, request.name, {}, {}),
                             diagnostics) &&
           write_export_file(folder / "mesh.glb.import", glb_import, diagnostics);
}

}  // namespace

bool write_godot_project(const ExportRequest& request, const GodotVersion& version,
                         const std::string& material, const fs::path& folder,
                         Diagnostics& diagnostics) {
    return write_mesh(request, version, folder, diagnostics) &&
           write_export_file(folder / "main.tscn", Scene(request, version).text(material),
                             diagnostics) &&
           write_export_file(folder / "project.godot", project_text(request, version), diagnostics);
}

}  // namespace wrinkle
