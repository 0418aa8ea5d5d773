#include "editor/document/files.h"

#include "base/file.h"
#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

void open_file(State& state, const fs::path& path) {
    state.path = path;
    state.save_refused.clear();
    Diagnostics problems;
    std::string why;
    const auto bytes = read_file(path, why);
    if (bytes) {
        state.history = History(read_document(*bytes, path.string(), problems));
        state.save_refused = state.document().lost;
    } else {
        Document empty;
        empty.file = path.string();
        state.history = History(std::move(empty));
        std::error_code ignored;
        if (fs::exists(path, ignored)) state.save_refused = path.string() + " " + why;
    }
    state.saved_serial = state.history.serial();
    state.view = {};
    state.fresh = false;
    state.status = bytes ? "Opened " + path.string() : "New graph " + path.string();
}

bool save_file(State& state) {
    if (!state.save_refused.empty()) {
        state.status = "Not saved, because the file could not be read whole: " + state.save_refused;
        return false;
    }
    std::string why;
    if (!write_file(state.path, write_document(state.document()), why)) {
        state.status = state.path.string() + " was not saved: it " + why;
        return false;
    }
    state.saved_serial = state.history.serial();
    state.status = "Saved " + state.path.filename().string();
    return true;
}

}  // namespace wrinkle::editor
