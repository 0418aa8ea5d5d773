// Mesh files built in memory for tests.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "mesh/load.h"

namespace wrinkle::test {

// A .gltf file with one buffer as a data URI. `accessors` are written unchanged.
class GltfText {
public:
    // Appends values as a buffer view with an accessor; returns the accessor's index.
    int add(const std::vector<float>& values, const std::string& type);
    int add_bytes(const std::string& bytes, const std::string& accessor);
    int add_indices(const std::vector<uint16_t>& indices);

    std::string attributes;  // "\"POSITION\": 0, ..."
    std::string primitive;   // more members of the primitive: ", \"indices\": 1"
    std::string more;        // more members of the file: ", \"materials\": [...]"
    std::string nodes = R"([{"mesh": 0}])";

    std::string text() const;
    std::string json(const std::string& buffer) const;
    std::string glb() const;
    const std::string& buffer() const { return buffer_; }

private:
    std::string buffer_;
    std::vector<std::string> views_, accessors_;
};

// A quad in the plane z = 0 from (0, 0) to (1, 1), facing +z, with uv = position in glTF's
// convention: v runs down the texture, so that (0, 0) has v 1.
GltfText square();

struct Loaded {
    std::optional<Mesh> mesh;
    Diagnostics diagnostics;
    std::string said;
};
Loaded load(const std::string& bytes, const std::string& name = "mesh.obj",
            const MeshFileOptions& options = {});

}  // namespace wrinkle::test
