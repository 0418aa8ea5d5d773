#include "mesh/gltf_parts.h"

#include "base/file.h"
#include "base/file_log.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

// tinygltf converts `extras` by recursion, so the nesting depth is limited.
constexpr int max_depth = 64;
constexpr size_t glb_header = 12;
constexpr size_t chunk_header = 8;

bool is_nested_too_deep(std::string_view json) {
    int depth = 0;
    bool in_string = false;
    for (size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_string && c == '\\')
            ++i;
        else if (c == '"')
            in_string = !in_string;
        else if (!in_string && (c == '{' || c == '['))
            if (++depth > max_depth) return true;
        if (!in_string && (c == '}' || c == ']')) --depth;
    }
    return false;
}

uint32_t number_at(std::string_view bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 0; i < 4; ++i)
        value |= uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    return value;
}

[[noreturn]] void fail(const std::string& message) {
    throw InvalidGltf(message, "a whole glTF 2.0 file; export it again");
}

// Returns the JSON text of a .gltf or .glb. Checks that the lengths in a .glb fit its size.
std::string_view json_of(std::string_view bytes) {
    if (!bytes.starts_with("glTF")) return bytes;
    if (bytes.size() < glb_header + chunk_header) fail("is truncated within its header");
    if (number_at(bytes, 4) != 2) fail("is glTF of version " + std::to_string(number_at(bytes, 4)));
    const uint64_t length = number_at(bytes, 8);
    const uint64_t json = number_at(bytes, glb_header);
    if (length > bytes.size())
        fail("is truncated: " + std::to_string(bytes.size()) + " of " + std::to_string(length) +
             " bytes");
    if (json > length - std::min<uint64_t>(length, glb_header + chunk_header))
        fail("says that its JSON is longer than the file");
    return bytes.substr(glb_header + chunk_header, json);
}

// File access of tinygltf: only files below the mesh's folder or the root, up to `bytes_left` bytes
// in total.
struct FileGate {
    const fs::path folder;
    const fs::path root;
    uint64_t bytes_left;
    std::vector<fs::path>* files_read;
    std::string refused;  // the first problem, one sentence

    bool is_image(const fs::path& path) const {
        const std::string type = path.extension().string();
        for (const char* image : {".png", ".jpg", ".jpeg", ".ktx2", ".webp", ".dds", ".basis"})
            if (type == image) return true;
        return false;
    }

    bool allows(const std::string& name) {
        const fs::path path(name);
        if (is_image(path)) return false;
        log_input(path);
        if (inside(folder, path) || (!root.empty() && inside(root, path))) return true;
        if (refused.empty())
            refused = "names the external file '" + path.filename().string() +
                      "', which is outside its folder and the root";
        return false;
    }

    bool read(const std::string& name, std::vector<unsigned char>& out) {
        std::error_code error;
        const uint64_t size = fs::file_size(name, error);
        std::string why;
        if (error)
            why = "cannot be read: " + error.message();
        else if (size > bytes_left)
            why = "is larger than the limit for a mesh";
        else if (const auto bytes = read_file(name, bytes_left, why)) {
            out.assign(bytes->begin(), bytes->end());
            bytes_left -= std::min<uint64_t>(bytes_left, bytes->size());
            if (files_read) files_read->emplace_back(name);
            return true;
        }
        if (refused.empty()) refused = "needs '" + name + "', which " + why;
        return false;
    }
};

// Replaces control characters by spaces and truncates to 300 characters.
std::string one_line(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
        text.pop_back();
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    return text.size() > 300 ? text.substr(0, 300) + "..." : text;
}

tinygltf::Model parse(std::string_view bytes, FileGate& gate) {
    tinygltf::TinyGLTF library;
    tinygltf::Model model;
    library.SetImageLoader([](auto...) { return true; }, nullptr);  // skips images
    const auto exists = [](const std::string& name, void* gate) {
        std::error_code ignored;
        return static_cast<FileGate*>(gate)->allows(name) && fs::is_regular_file(name, ignored);
    };
    const auto same_path = [](const std::string& name, void*) { return name; };
    const auto read_whole = [](std::vector<unsigned char>* out, std::string*,
                               const std::string& name, void* gate) {
        return static_cast<FileGate*>(gate)->read(name, *out);
    };
    const auto write_nothing = [](auto...) { return false; };
    library.SetFsCallbacks({exists, same_path, read_whole, write_nothing, &gate});
    std::string error, ignored;
    const auto size = static_cast<unsigned int>(bytes.size());
    const std::string base = gate.folder.string();
    bool ok = false;
    try {
        ok = bytes.starts_with("glTF")
                 ? library.LoadBinaryFromMemory(
                       &model, &error, &ignored,
                       reinterpret_cast<const unsigned char*>(bytes.data()), size, base)
                 : library.LoadASCIIFromString(&model, &error, &ignored, bytes.data(), size, base);
    } catch (const std::exception& problem) {
        error = problem.what();
    }
    if (ok) return model;
    if (gate.refused.empty()) fail("is not valid glTF: " + one_line(error));
    throw InvalidGltf(
        gate.refused,
        "external files must be below the mesh's folder, or --root names a folder that "
        "holds them");
}

}  // namespace

tinygltf::Model read_gltf_file(std::string_view bytes, const fs::path& path,
                               const MeshFileOptions& options) {
    if (is_nested_too_deep(json_of(bytes)))
        fail("nests objects and arrays deeper than " + std::to_string(max_depth) + " levels");
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    FileGate gate{folder, options.root, options.limits.max_bytes, options.read, ""};
    return parse(bytes, gate);
}

}  // namespace wrinkle
