#include "graph/named_files.h"

#include "base/file_log.h"

namespace wrinkle {
namespace fs = std::filesystem;

const NamedFiles::Found& NamedFiles::find(size_t file, std::string_view name) {
    const auto [entry, is_new] = found_.try_emplace({file, std::string(name)});
    Found& found = entry->second;
    if (!is_new) return found;
    std::error_code error;
    log_input(fs::path(project_->files[file].document.file).parent_path() / name);
    found.path = resolve_file(*project_, file, name);
    if (found.path) found.type = fs::status(*found.path, error).type();
    return found;
}

}  // namespace wrinkle
