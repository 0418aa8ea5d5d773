#include "mesh/files.h"

#include <cstring>

namespace wrinkle::test {
namespace {

std::string base64(const std::string& bytes) {
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t group = 0;
        for (size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0);
        for (size_t k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

template <typename T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

std::string list_of(const std::vector<std::string>& items) {
    std::string text = "[";
    for (const std::string& item : items)
        text += (text.size() > 1 ? ", " : "") + item;
    return text + "]";
}

std::string little_endian(uint32_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i)
        bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

}  // namespace

int GltfText::add_bytes(const std::string& bytes, const std::string& accessor) {
    while (buffer_.size() % 4 != 0)
        buffer_ += '\0';
    views_.push_back(R"({"buffer": 0, "byteOffset": )" + std::to_string(buffer_.size()) +
                     R"(, "byteLength": )" + std::to_string(bytes.size()) + "}");
    accessors_.push_back(R"({"bufferView": )" + std::to_string(views_.size() - 1) + ", " +
                         accessor + "}");
    buffer_ += bytes;
    return static_cast<int>(accessors_.size()) - 1;
}

int GltfText::add(const std::vector<float>& values, const std::string& type) {
    const size_t width = type == "SCALAR" ? 1 : static_cast<size_t>(type.back() - '0');
    return add_bytes(bytes_of(values), R"("componentType": 5126, "count": )" +
                                           std::to_string(values.size() / width) +
                                           R"(, "type": ")" + type + "\"");
}

int GltfText::add_indices(const std::vector<uint16_t>& indices) {
    return add_bytes(bytes_of(indices), R"("componentType": 5123, "type": "SCALAR", "count": )" +
                                            std::to_string(indices.size()));
}

std::string GltfText::json(const std::string& buffer) const {
    return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": )" +
           nodes + R"(, "meshes": [{"primitives": [{"attributes": {)" + attributes + "}" +
           primitive + R"(}]}], "buffers": [)" + buffer + R"(], "bufferViews": )" +
           list_of(views_) + R"(, "accessors": )" + list_of(accessors_) + more + "}";
}

std::string GltfText::text() const {
    return json(R"({"byteLength": )" + std::to_string(buffer_.size()) +
                R"(, "uri": "data:application/octet-stream;base64,)" + base64(buffer_) + "\"}");
}

std::string GltfText::glb() const {
    std::string text = json(R"({"byteLength": )" + std::to_string(buffer_.size()) + "}");
    std::string bytes = buffer_;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    const auto size = [](const std::string& s) { return static_cast<uint32_t>(s.size()); };
    return "glTF" + little_endian(2) + little_endian(28 + size(text) + size(bytes)) +
           little_endian(size(text)) + "JSON" + text + little_endian(size(bytes)) +
           std::string("BIN\0", 4) + bytes;
}

GltfText square() {
    GltfText gltf;
    gltf.add({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3");
    gltf.add({0, 1, 1, 1, 1, 0, 0, 0}, "VEC2");
    gltf.add_indices({0, 1, 2, 0, 2, 3});
    gltf.attributes = R"("POSITION": 0, "TEXCOORD_0": 1)";
    gltf.primitive = R"(, "indices": 2)";
    return gltf;
}

Loaded load(const std::string& bytes, const std::string& name, const MeshFileOptions& options) {
    Loaded result;
    result.mesh = load_mesh_bytes(bytes, name, options, result.diagnostics);
    result.said = to_text(result.diagnostics);
    return result;
}

}  // namespace wrinkle::test
