#include "graph/named_files.h"

namespace wrinkle {
namespace fs = std::filesystem;

const NamedFiles::Found& NamedFiles::find(size_t file, std::string_view name) {
    auto& here = found_[file];
    const auto known = here.find(name);
    if (known != here.end()) return known->second;
    if (auto plain = plain_file(file, name))
        return here.emplace(name, std::move(*plain)).first->second;
    Found found;
    found.path = resolve_file(*project_, file, name);
    std::error_code error;
    if (found.path) found.type = fs::status(*found.path, error).type();
    return here.emplace(name, std::move(found)).first->second;
}

// Fast path for a regular file that is not a link, in a folder inside the root; else std::nullopt.
std::optional<NamedFiles::Found> NamedFiles::plain_file(size_t file, std::string_view name) {
    const size_t slash = name.rfind('/') + 1;  // 0 if there is no slash
    const std::string_view folder = name.substr(0, slash), last = name.substr(slash);
    if (last.empty() || last == "." || last == ".." || name.find('\0') != name.npos) return {};
    auto known = folders_[file].find(folder);
    if (known == folders_[file].end())
        known = folders_[file].emplace(folder, resolve_file(*project_, file, folder)).first;
    if (!known->second) return {};
    std::string path = known->second->native();
    if (!path.ends_with('/')) path += '/';
    path += last;
    Found found;
    found.path = std::move(path);
    std::error_code error;
    found.type = fs::symlink_status(*found.path, error).type();
    if (found.type != fs::file_type::regular) return {};
    return found;
}

}  // namespace wrinkle
