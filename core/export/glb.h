// A binary glTF 2.0 file (GLB) of one mesh with one material (Khronos, glTF 2.0 specification,
// sections 3.6, 3.7 and 4.4).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "json/value.h"
#include "mesh/mesh.h"

namespace wrinkle {

using JsonMembers = std::vector<std::pair<std::string, json::Value>>;

json::Value json_index(size_t index);

// Attribute of the vertex colors: _MASK, which viewers ignore, or COLOR_0, which glTF multiplies
// into the base color.
enum class GlbColors : uint8_t { mask, color };

class Glb {
public:
    // Appends an image and a texture that reads it with mips, repeated; returns the texture's
    // index. The name may hold any characters.
    size_t add_texture(const std::string& name, std::string_view png);

    // Appends the mesh and returns the file: call it once, last. Uvs are stored with v downwards.
    std::string bytes(const Mesh& mesh, const std::string& name, const JsonMembers& material,
                      std::span<const std::string> extensions, GlbColors colors = GlbColors::mask);

private:
    size_t add_view(std::string_view bytes, std::optional<int> target);
    template <class Vector>
    size_t add_accessor(std::span<const Vector> values, std::string_view type, bool bounds);
    size_t add_indices(const Mesh& mesh);
    json::Value primitive(const Mesh& mesh, GlbColors colors);
    std::string container(const std::string& text) const;

    std::string binary_;
    std::vector<json::Value> views_, accessors_, images_, textures_;
};

}  // namespace wrinkle
