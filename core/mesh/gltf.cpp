#include "mesh/readers.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <numeric>

#include "base/diagnostics.h"
#include "mesh/gltf_parts.h"
#include "mesh/vertex_frames.h"

namespace wrinkle {
namespace {

// Returns true for extensions that do not change vertex positions.
bool is_harmless(const std::string& extension) {
    for (const char* prefix : {"KHR_materials_", "KHR_texture_", "EXT_texture_", "KHR_lights_",
                               "KHR_mesh_quantization", "KHR_xmp"})
        if (extension.starts_with(prefix)) return true;
    return false;
}

glm::dmat4 matrix_of(const tinygltf::Node& node) {
    glm::dmat4 m(1);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i)
            m[i / 4][i % 4] = node.matrix[static_cast<size_t>(i)];
        return m;
    }
    const auto& [r, s, t] = std::tie(node.rotation, node.scale, node.translation);
    if (r.size() == 4) m = glm::mat4_cast(glm::normalize(glm::dquat(r[3], r[0], r[1], r[2])));
    if (s.size() == 3)
        for (int i = 0; i < 3; ++i)
            m[i] *= s[static_cast<size_t>(i)];
    if (t.size() == 3) m[3] = glm::dvec4(t[0], t[1], t[2], 1);
    return m;
}

bool has_triangles(int mode) {  // false for points and lines; an absent mode is a list
    return mode < 0 || mode == TINYGLTF_MODE_TRIANGLES || mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
           mode == TINYGLTF_MODE_TRIANGLE_FAN;
}

// Converts triangle lists, strips and fans to a list.
void list_triangles(int mode, const std::vector<uint32_t>& in, std::vector<uint32_t>& out) {
    if (mode == TINYGLTF_MODE_TRIANGLES || mode < 0) {
        out.assign(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(in.size() / 3 * 3));
        return;
    }
    const bool strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
    for (size_t i = 0; i + 2 < in.size(); ++i) {
        const size_t turned = strip ? i % 2 : 0;
        out.insert(out.end(), {in[strip ? i : 0], in[i + 1 + turned], in[i + 2 - turned]});
    }
}

class GltfReader {
public:
    GltfReader(const tinygltf::Model& model, std::string file, const MeshLimits& limits,
               Diagnostics& diagnostics)
        : model_(model), file_(std::move(file)), limits_(limits), diagnostics_(diagnostics) {}

    std::optional<Mesh> read() {
        bool known = true;
        for (const std::string& extension : model_.extensionsRequired) {
            if (is_harmless(extension)) continue;
            add(Severity::error, "needs the extension '" + extension + "'",
                "export it without; KHR_texture_transform and KHR_mesh_quantization are known");
            known = false;
        }
        if (!known) return {};
        try {
            read_scene();
        } catch (const InvalidGltf& fault) {
            add(Severity::error, fault.message, fault.expected);
            return {};
        }
        return std::move(mesh_);
    }
    bool is_double_sided() const { return double_sided_; }

private:
    struct SceneNode {
        int node;
        glm::dmat4 parent;
    };

    void read_scene() {
        std::vector<SceneNode> open;
        for (const int root : roots())
            open.push_back({root, glm::dmat4(1)});
        if (model_.nodes.empty())
            for (size_t i = 0; i < model_.meshes.size(); ++i)
                add_mesh(static_cast<int>(i), glm::dmat4(1));
        std::vector<bool> seen(model_.nodes.size());
        while (!open.empty()) {
            const SceneNode next = open.back();
            open.pop_back();
            const auto index = static_cast<size_t>(next.node);
            if (next.node < 0 || index >= model_.nodes.size())
                throw InvalidGltf("there is no node " + std::to_string(next.node));
            if (seen[index])
                throw InvalidGltf("node " + std::to_string(index) +
                                  " has two parents or is its own");
            seen[index] = true;
            const tinygltf::Node& node = model_.nodes[index];
            const glm::dmat4 m = next.parent * matrix_of(node);
            if (node.mesh >= 0) add_mesh(node.mesh, node.skin >= 0 ? glm::dmat4(1) : m);
            for (const int child : node.children)
                open.push_back({child, m});
        }
    }

    // Returns the root nodes of the default scene; else of the first scene; else all nodes without
    // a parent.
    std::vector<int> roots() const {
        const auto wanted = static_cast<size_t>(std::max(model_.defaultScene, 0));
        if (wanted < model_.scenes.size()) return model_.scenes[wanted].nodes;
        std::vector<bool> is_child(model_.nodes.size());
        for (const tinygltf::Node& node : model_.nodes)
            for (const int child : node.children)
                if (child >= 0 && static_cast<size_t>(child) < is_child.size())
                    is_child[static_cast<size_t>(child)] = true;
        std::vector<int> result;
        for (size_t i = 0; i < is_child.size(); ++i)
            if (!is_child[i]) result.push_back(static_cast<int>(i));
        return result;
    }

    void add_mesh(int index, const glm::dmat4& to_scene) {
        if (static_cast<size_t>(index) >= model_.meshes.size())
            throw InvalidGltf("there is no mesh " + std::to_string(index));
        const auto& primitives = model_.meshes[static_cast<size_t>(index)].primitives;
        for (size_t i = 0; i < primitives.size(); ++i) {
            where_ = "mesh " + std::to_string(index) + ", primitive " + std::to_string(i) + ": ";
            Mesh part;
            if (!read_primitive(primitives[i], part)) continue;
            if (mesh_.indices.size() + part.indices.size() > limits_.max_corners ||
                mesh_.vertex_count() + part.vertex_count() > limits_.max_corners)
                throw InvalidGltf(
                    "more than " + std::to_string(limits_.max_corners / 3) + " triangles",
                    "split the file or simplify the mesh");
            const auto material = static_cast<size_t>(primitives[i].material);
            double_sided_ |=
                material < model_.materials.size() && model_.materials[material].doubleSided;
            complete(part);
            transform(part, to_scene);
            append(mesh_, part);
        }
        where_.clear();
    }

    // Returns false if the primitive has no triangles.
    bool read_primitive(const tinygltf::Primitive& primitive, Mesh& part) {
        if (!has_triangles(primitive.mode)) return false;
        read_vector(primitive, "POSITION", part.positions, 3);
        read_vector(primitive, "NORMAL", part.normals, 3);
        read_vector(primitive, "TANGENT", part.tangents, 4);
        read_vector(primitive, "COLOR_0", part.colors, 3);
        read_uvs(primitive, part);
        if (part.positions.empty()) throw InvalidGltf("has no positions");
        list_triangles(primitive.mode, read_order(primitive, part.vertex_count()), part.indices);
        return !part.indices.empty();
    }

    // Adds `part` to the context of messages while `read` runs.
    template <typename Read>
    auto within(const std::string& part, Read read) {
        const size_t before = where_.size();
        where_ += part + ": ";
        auto result = read();
        where_.resize(before);
        return result;
    }

    // Leaves `out` empty if the attribute is absent. Colors may have three components.
    template <typename Vector>
    void read_vector(const tinygltf::Primitive& primitive, const std::string& name,
                     std::vector<Vector>& out, int least) {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return;
        const AccessorFloats floats =
            within(name, [&] { return read_floats(model_, found->second, limits_.max_corners); });
        // Several nodes may reference one mesh, and each reads it again: limit the total.
        elements_read_ += floats.count;
        if (elements_read_ > 16 * limits_.max_corners)
            throw InvalidGltf("more than " + std::to_string(limits_.max_corners) + " vertices",
                              "split the file or simplify the mesh");
        const int width = floats.components;
        const auto position = primitive.attributes.find("POSITION");
        if (width < least || width > Vector::length())
            throw InvalidGltf(name + " has " + std::to_string(width) + " components");
        if (position != primitive.attributes.end() && name != "POSITION" &&
            floats.count != model_.accessors[static_cast<size_t>(position->second)].count)
            throw InvalidGltf(name + " and POSITION differ in length");
        out.assign(floats.count, Vector(1));
        for (size_t i = 0; i < floats.count; ++i)
            for (int k = 0; k < width; ++k)
                out[i][k] = floats.values[i * static_cast<size_t>(width) + static_cast<size_t>(k)];
    }

    void read_uvs(const tinygltf::Primitive& primitive, Mesh& part) {
        const UvTransforms transforms = uv_transforms(model_, primitive.material);
        for (size_t set = 0; set < max_uv_sets; ++set) {
            auto& uvs = part.uvs[set];
            read_vector(primitive, "TEXCOORD_" + std::to_string(set), uvs, 2);
            const UvTransform move = transforms.sets[set].value_or(UvTransform());
            for (glm::vec2& uv : uvs) {
                if (move != UvTransform()) uv = move.apply(uv);
                uv.y = 1 - uv.y;
            }
            if (set == 0 && !uvs.empty() && !move.keeps_tangents()) part.tangents.clear();
        }
        if (transforms.differ)
            warn("its textures move one uv set in different ways; the first one's way is taken");
    }

    std::vector<uint32_t> read_order(const tinygltf::Primitive& primitive, size_t vertices) {
        if (primitive.indices < 0) {
            std::vector<uint32_t> order(vertices);
            std::iota(order.begin(), order.end(), 0U);
            return order;
        }
        std::vector<uint32_t> indices = within("indices", [&] {
            return read_indices(model_, primitive.indices, limits_.max_corners);
        });
        for (const uint32_t index : indices)
            if (index >= vertices)
                throw InvalidGltf("index " + std::to_string(index) + " of " +
                                  std::to_string(vertices) + " vertices");
        return indices;
    }

    // glTF: tangents without normals are ignored.
    void complete(Mesh& part) {
        if (part.normals.empty()) part.tangents.clear();
        const size_t bad = complete_normals(part);
        if (bad > 0)
            warn(std::to_string(bad) + " normals are zero or no numbers; smooth ones replace them");
        if (!part.tangents.empty() && !are_tangents(part)) {
            warn("its tangents are not unit vectors; MikkTSpace's replace them");
            part.tangents.clear();
        }
        ensure_tangents(part);
    }

    static bool are_tangents(const Mesh& part) {
        for (const glm::vec4& tangent : part.tangents) {
            const double length = glm::length(glm::dvec3(tangent));
            if (!(length > 0.5 && length < 2 && std::abs(tangent.w) == 1)) return false;
        }
        return true;
    }

    void warn(const std::string& message) { add(Severity::warning, message, ""); }

    void add(Severity severity, const std::string& message, const std::string& expected) {
        const RuleId rule =
            severity == Severity::error ? RuleId::mesh_unreadable : RuleId::mesh_repaired;
        diagnostics_.add(file_problem(severity, rule, file_, where_ + message, expected));
    }

    const tinygltf::Model& model_;
    std::string file_;
    const MeshLimits& limits_;
    Diagnostics& diagnostics_;
    std::string where_;
    bool double_sided_ = false;
    uint64_t elements_read_ = 0;
    Mesh mesh_;
};

}  // namespace

std::optional<Mesh> read_gltf(std::string_view bytes, const std::filesystem::path& path,
                              const MeshFileOptions& options, Diagnostics& diagnostics) {
    try {
        const tinygltf::Model model = read_gltf_file(bytes, path, options);
        GltfReader reader(model, path.string(), options.limits, diagnostics);
        auto mesh = reader.read();
        if (options.double_sided) *options.double_sided = mesh && reader.is_double_sided();
        return mesh;
    } catch (const InvalidGltf& fault) {
        diagnostics.add(file_problem(Severity::error, RuleId::mesh_unreadable, path.string(),
                                     fault.message, fault.expected));
        return {};
    }
}

}  // namespace wrinkle
