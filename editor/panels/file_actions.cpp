#include "editor/panels/file_actions.h"

#include "editor/document/files.h"

namespace wrinkle::editor {

void open_chosen(State& state, const std::filesystem::path& file) {
    if (state.dirty())
        state.status = "Save " + state.path.filename().string() + " first, or undo its edits.";
    else
        open_file(state, file);
}

bool save_chosen(State& state, const std::filesystem::path& file) {
    const std::filesystem::path before = state.path;
    state.path = file;
    if (save_file(state)) return true;
    state.path = before;
    return false;
}

void new_chosen(State& state) {
    state.start.left = true;
}

std::vector<std::filesystem::path> recent_files(const State&) {
    return {};
}

}  // namespace wrinkle::editor
