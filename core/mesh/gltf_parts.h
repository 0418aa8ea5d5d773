// Parts of the glTF reader: parsing of the file, values of accessors, and uv transforms of
// materials. All are safe for untrusted files.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/load.h"

namespace wrinkle {

// Thrown by the functions below; read_gltf() reports it.
struct InvalidGltf {
    explicit InvalidGltf(std::string message,
                         std::string expected = "a valid glTF 2.0 file; export it again")
        : message(std::move(message)), expected(std::move(expected)) {}
    std::string message, expected;
};

// Parses a file with tinygltf: nesting, lengths and external files are checked before and during
// parsing; images are not read.
tinygltf::Model read_gltf_file(std::string_view bytes, const std::filesystem::path& path,
                               const MeshFileOptions& options);

// Values of an accessor. Normalised integers are converted to floats as in glTF 2.0, section
// 3.6.2.2 (c / 255, max(c / 127, -1), and so on); sparse accessors are resolved.
struct AccessorFloats {
    int components = 0;
    size_t count = 0;
    std::vector<float> values;  // count * components
};

// Both check every range. read_indices() reads scalar unsigned integers of 1, 2 or 4 bytes.
AccessorFloats read_floats(const tinygltf::Model& model, int accessor, uint64_t max_count);
std::vector<uint32_t> read_indices(const tinygltf::Model& model, int accessor, uint64_t max_count);

// KHR_texture_transform: uv' = offset + R(rotation) (scale uv) in glTF's coordinates, v downwards.
// R rotates by (cos, sin; -sin, cos), which is counter-clockwise on screen.
struct UvTransform {
    glm::dvec2 offset{0};
    glm::dvec2 scale{1};
    double rotation = 0;

    glm::vec2 apply(glm::vec2 uv) const;
    bool keeps_tangents() const { return rotation == 0 && scale.x > 0 && scale.y > 0; }
    friend bool operator==(const UvTransform&, const UvTransform&) = default;
};

struct UvTransforms {
    std::array<std::optional<UvTransform>, max_uv_sets> sets;
    bool differ = false;  // two textures transform one set differently; the first one is used
};

// Returns the transforms that a material applies to the uv sets of a primitive.
UvTransforms uv_transforms(const tinygltf::Model& model, int material);

}  // namespace wrinkle
