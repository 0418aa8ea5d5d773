#include "editor/model/session.h"

#include "base/file.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

fs::path folder_of(const fs::path& path, const fs::path& unsaved_folder) {
    return path.empty() ? real_path(unsaved_folder) : real_path(path).parent_path();
}

}  // namespace

std::string file_name_of(const fs::path& path) {
    return path.empty() ? "untitled.json" : path.filename().string();
}

const Costs* Session::costs() const {
    if (built.version < follow.first || !built.uniform) return nullptr;
    if (follow.is_counted()) return &*follow.counted;
    return built.costs ? &*built.costs : nullptr;
}

fs::path Session::folder() const {
    return folder_of(path, unsaved_folder);
}

fs::path Session::root() const {
    return folder_of(parent_graphs.empty() ? path : parent_graphs.front().path, unsaved_folder);
}

std::string Session::title() const {
    return file_name() + (dirty() ? " *" : "") + " - Wrinkle";
}

void Session::commit(std::string name, Document document, const std::string& merge) {
    if (history.commit(name, std::move(document), merge)) status = std::move(name);
}

}  // namespace wrinkle::editor
