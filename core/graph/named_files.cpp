#include "graph/named_files.h"

namespace wrinkle {

const NamedFiles::Found& NamedFiles::find(size_t file, std::string_view name) {
    auto& here = found_[file];
    const auto known = here.find(name);
    if (known != here.end()) return known->second;
    Found found;
    found.path = resolve_file(*project_, file, name);
    std::error_code error;
    if (found.path) found.type = std::filesystem::status(*found.path, error).type();
    return here.emplace(name, std::move(found)).first->second;
}

}  // namespace wrinkle
