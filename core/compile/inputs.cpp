#include "compile/inputs.h"

#include <set>

#include "lower/named_images.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

// Returns `wanted` with "." and ".." removed, or `real` if that is an existing file and the result
// would not name it: after a symbolic link, ".." leads to the parent of the link's target.
std::string spelled(const fs::path& wanted, const fs::path& real) {
    const fs::path shorter = wanted.lexically_normal();
    std::error_code error;
    const bool same = !fs::exists(real, error) || fs::equivalent(shorter, real, error);
    return same && !error ? shorter.string() : real.string();
}

class Collector {
public:
    void add(InputFile::Kind kind, std::string path) {
        if (seen_.insert(path).second) files.push_back({kind, std::move(path)});
    }

    std::vector<InputFile> files;  // without duplicates, in the order of add()

private:
    std::set<std::string> seen_;
};

}  // namespace

std::string_view name_of(InputFile::Kind kind) {
    constexpr std::string_view names[] = {"graph", "image", "plugin", "preset"};
    return names[static_cast<size_t>(kind)];
}

std::vector<InputFile> inputs_of(const Project& project, const Types& types) {
    Collector found;
    std::error_code ignored;
    // The top graph is not a regular file if it is a stream or text in memory.
    for (const Project::File& file : project.files)
        if (&file != project.files.data() || fs::is_regular_file(file.path, ignored))
            found.add(InputFile::Kind::graph, spelled(file.document.file, file.path));
    for (size_t f = 0; f < project.files.size(); ++f) {
        const fs::path folder = fs::path(project.files[f].document.file).parent_path();
        std::set<std::string> names;  // many nodes may read one image
        for (const NamedImage& image : named_images(project, types, f))
            if (image.path && names.insert(image.name).second)
                found.add(InputFile::Kind::image, spelled(folder / image.name, *image.path));
    }
    for (size_t f = 0; f < project.files.size(); ++f)
        for (size_t i = 0; i < project.files[f].document.nodes.size(); ++i) {
            const NodeType* type = types.of(f, i);
            if (type && type->code) found.add(InputFile::Kind::plugin, type->origin);
        }
    for (const std::string& preset : project.preset_files)
        found.add(InputFile::Kind::preset, preset);
    return std::move(found.files);
}

}  // namespace wrinkle
