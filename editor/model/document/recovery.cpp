#include "editor/model/document/recovery.h"
#include "base/file.h"

#include <imgui.h>

#include "editor/model/document/files.h"
#include "graph/read.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

void say_failure(State& state, const std::error_code& error) {
    const std::string words = disk_words(error);
    if (state.keeping.unkept != words)
        state.status = "Edits are not kept for recovery: " + words + ". Save them soon.";
    state.keeping.unkept = words;
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return real_path(a, error) == real_path(b, error);
}

}  // namespace

bool keep_edits_now(State& state) {
    Persistence& keeping = state.keeping;
    if (keeping.folders.state.empty()) return false;
    const uint64_t serial = state.history.serial();
    if (keeping.journal.exists() && keeping.journalled == serial) return true;
    const fs::path graph = state.path.empty() ? state.folder() / "" : state.path;
    const std::error_code error =
        keeping.journal.keep(keeping.folders.state, graph, state.save_refused, state.document());
    if (error) {
        say_failure(state, error);
        return false;
    }
    keeping.unkept.clear();
    keeping.journalled = serial;
    keeping.kept_at = std::time(nullptr);
    return true;
}

void keep_edits(State& state) {
    Persistence& keeping = state.keeping;
    if (!state.dirty()) return keeping.journal.drop();
    const bool kept = keeping.journal.exists() && keeping.journalled == state.history.serial();
    if (kept || (state.history.merging() && ImGui::IsAnyMouseDown())) return;
    const bool wait = !keeping.unkept.empty() && !keeping.try_again;
    keeping.try_again = false;
    if (!wait) keep_edits_now(state);
}

std::string kept_words(const State& state) {
    const Persistence& keeping = state.keeping;
    if (!state.dirty()) return state.path.empty() ? "" : "Saved";
    if (!keeping.unkept.empty()) return "Edits are in memory alone";
    if (!keeping.journal.exists()) return "Not saved";
    char text[40] = "All edits kept";
    if (const tm* local = std::localtime(&keeping.kept_at))
        std::strftime(text, sizeof text, "All edits kept %H:%M", local);
    return text;
}

void look_for_recoverable(State& state) {
    state.keeping.recoverable.clear();
    if (!state.keeping.folders.state.empty())
        state.keeping.recoverable = list_recoverable(state.keeping.folders.state);
}

void offer_recovery(State& state) {
    if (state.question.open()) return;
    for (const Recoverable& found : state.keeping.recoverable) {
        if (!state.path.empty() && !same_file(found.graph, state.path)) continue;
        state.question = {.kind = Question::Kind::recover, .file = found.journal};
        return;
    }
}

void recover(State& state, const Recoverable& found) {
    const Recoverable taken = found;  // forget() rebuilds the list
    // The crashed program may have saved after this one had read the file.
    const bool is_open = !state.path.empty() && same_file(taken.graph, state.path);
    if (taken.graph.empty())
        new_file(state, taken.folder);
    else if (!is_open || state.dirty() || compare(state.keeping.disk, state.path) != OnDisk::same)
        open_file(state, taken.graph);
    Diagnostics shown_by_the_build;
    state.commit("Recover unsaved edits",
                 read_document(taken.text, state.path.string(), shown_by_the_build));
    if (!taken.refused.empty()) state.save_refused = taken.refused;
    state.status = "Recovered the unsaved edits of " + state.file_name();
    if (keep_edits_now(state)) forget(state, taken);
}

void forget(State& state, const Recoverable& found) {
    std::error_code ignored;
    fs::remove(found.journal, ignored);
    look_for_recoverable(state);
}

}  // namespace wrinkle::editor
