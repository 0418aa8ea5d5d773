#include "export/glb.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "json/write.h"

namespace wrinkle {
namespace {

using json::Value;

// Constants of the specification.
constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int component_float = 5126, component_uint = 5125;
constexpr int filter_linear = 9729, filter_linear_mips = 9987, wrap_repeat = 10497;
constexpr uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

static_assert(std::endian::native == std::endian::little, "glTF stores little-endian numbers");

Value integer(int number) {
    return Value::number(number);
}

template <class T>
std::string_view bytes_of_values(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

void pad(std::string& bytes, char with) {
    bytes.resize((bytes.size() + 3) / 4 * 4, with);
}

void append_word(std::string& bytes, size_t number) {
    const auto word = static_cast<uint32_t>(number);
    bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

// The least or greatest value of each component.
template <class Vector, class Choose>
Value bound(std::span<const Vector> values, Choose choose) {
    Vector found = values[0];
    for (const Vector& value : values)
        for (int i = 0; i < Vector::length(); ++i)
            found[i] = choose(found[i], value[i]);
    std::vector<Value> components;
    for (int i = 0; i < Vector::length(); ++i)
        components.push_back(Value::single(found[i]));
    return Value::array(components);
}

std::vector<glm::vec2> with_v_down(std::vector<glm::vec2> uvs) {
    for (glm::vec2& uv : uvs)
        uv.y = 1 - uv.y;
    return uvs;
}

}  // namespace

json::Value json_index(size_t index) {
    return Value::number(static_cast<double>(index));
}

size_t Glb::add_view(std::string_view bytes, std::optional<int> target) {
    pad(binary_, 0);
    JsonMembers view = {{"buffer", integer(0)},
                        {"byteOffset", json_index(binary_.size())},
                        {"byteLength", json_index(bytes.size())}};
    if (target) view.emplace_back("target", integer(*target));
    binary_ += bytes;
    views_.push_back(Value::object(view));
    return views_.size() - 1;
}

size_t Glb::add_texture(const std::string& name, std::string_view png) {
    const size_t view = add_view(png, {});
    images_.push_back(Value::object(JsonMembers{{"name", Value::string(name)},
                                                {"mimeType", Value::string("image/png")},
                                                {"bufferView", json_index(view)}}));
    textures_.push_back(Value::object(
        JsonMembers{{"sampler", integer(0)}, {"source", json_index(images_.size() - 1)}}));
    return textures_.size() - 1;
}

template <class Vector>
size_t Glb::add_accessor(std::span<const Vector> values, std::string_view type, bool bounds) {
    JsonMembers accessor = {
        {"bufferView", json_index(add_view(bytes_of_values(values), array_buffer))},
        {"componentType", integer(component_float)},
        {"count", json_index(values.size())},
        {"type", Value::string(type)}};
    if (bounds) {
        const auto least = [](float a, float b) { return std::min(a, b); };
        const auto greatest = [](float a, float b) { return std::max(a, b); };
        accessor.emplace_back("min", bound(values, least));
        accessor.emplace_back("max", bound(values, greatest));
    }
    accessors_.push_back(Value::object(accessor));
    return accessors_.size() - 1;
}

size_t Glb::add_indices(const Mesh& mesh) {
    const std::span<const uint32_t> indices = mesh.indices;
    const size_t view = add_view(bytes_of_values(indices), element_array_buffer);
    accessors_.push_back(Value::object(JsonMembers{{"bufferView", json_index(view)},
                                                   {"componentType", integer(component_uint)},
                                                   {"count", json_index(indices.size())},
                                                   {"type", Value::string("SCALAR")}}));
    return accessors_.size() - 1;
}

json::Value Glb::primitive(const Mesh& mesh, GlbColors colors) {
    JsonMembers attributes;
    const auto add = [&]<class Vector>(const std::string& name, const std::vector<Vector>& values,
                                       std::string_view type, bool bounds = false) {
        if (values.empty()) return;
        const size_t accessor = add_accessor(std::span<const Vector>(values), type, bounds);
        attributes.emplace_back(name, json_index(accessor));
    };
    add("POSITION", mesh.positions, "VEC3", true);
    add("NORMAL", mesh.normals, "VEC3");
    add("TANGENT", mesh.tangents, "VEC4");
    for (size_t set = 0; set < max_uv_sets; ++set)
        add("TEXCOORD_" + std::to_string(set), with_v_down(mesh.uvs[set]), "VEC2");
    add(colors == GlbColors::mask ? "_MASK" : "COLOR_0", mesh.colors, "VEC4");
    return Value::object(JsonMembers{{"attributes", Value::object(attributes)},
                                     {"indices", json_index(add_indices(mesh))},
                                     {"material", integer(0)}});
}

std::string Glb::container(const std::string& text) const {
    std::string json_bytes = text, binary = binary_;
    pad(json_bytes, ' ');
    pad(binary, 0);
    std::string file;
    append_word(file, glb_magic);
    append_word(file, 2);
    append_word(file, 12 + 8 + json_bytes.size() + 8 + binary.size());
    append_word(file, json_bytes.size());
    append_word(file, json_chunk);
    file += json_bytes;
    append_word(file, binary.size());
    append_word(file, binary_chunk);
    return file + binary;
}

std::string Glb::bytes(const Mesh& mesh, const std::string& name, const JsonMembers& material,
                       std::span<const std::string> extensions, GlbColors colors) {
    const auto one = [](const Value& value) { return Value::array({&value, 1}); };
    const Value drawn = primitive(mesh, colors);
    const Value zero = integer(0);
    JsonMembers root = {
        {"asset", Value::object(JsonMembers{{"version", Value::string("2.0")},
                                            {"generator", Value::string("Wrinkle")}})},
        {"scene", zero},
        {"scenes", one(Value::object(JsonMembers{{"nodes", one(zero)}}))},
        {"nodes", one(Value::object(JsonMembers{{"mesh", zero}, {"name", Value::string(name)}}))},
        {"meshes", one(Value::object(JsonMembers{{"primitives", one(drawn)}}))},
        {"materials", one(Value::object(material))}};
    if (!textures_.empty()) {
        root.emplace_back("textures", Value::array(textures_));
        root.emplace_back("images", Value::array(images_));
        root.emplace_back("samplers",
                          one(Value::object(JsonMembers{{"magFilter", integer(filter_linear)},
                                                        {"minFilter", integer(filter_linear_mips)},
                                                        {"wrapS", integer(wrap_repeat)},
                                                        {"wrapT", integer(wrap_repeat)}})));
    }
    std::vector<Value> used;
    for (const std::string& extension : extensions)
        used.push_back(Value::string(extension));
    if (!used.empty()) root.emplace_back("extensionsUsed", Value::array(used));
    root.emplace_back("accessors", Value::array(accessors_));
    root.emplace_back("bufferViews", Value::array(views_));
    const size_t length = (binary_.size() + 3) / 4 * 4;
    root.emplace_back("buffers",
                      one(Value::object(JsonMembers{{"byteLength", json_index(length)}})));
    return container(json::one_line(Value::object(root)));
}

}  // namespace wrinkle
