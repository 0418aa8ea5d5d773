#include "editor/model/document/levels.h"

#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

void exchange(State& state, Level& level) {
    std::swap(state.path, level.path);
    std::swap(state.history, level.history);
    std::swap(state.saved_serial, level.saved_serial);
    std::swap(state.save_refused, level.save_refused);
    std::swap(state.keeping.disk, level.disk);
    std::swap(state.keeping.journal, level.journal);
    std::swap(state.keeping.journalled, level.journalled);
    std::swap(state.view, level.view);
}

// "strap.json > weave.json > strap.json"
std::string circle(const State& state, size_t from) {
    const std::vector<std::string> files = open_files(state);
    std::string text = files[from] + " holds itself: ";
    for (size_t i = from; i < files.size(); ++i)
        text += files[i] + " > ";
    return text + files[from] + ".";
}

std::string why_not_opened(const State& state, const Node& node, const fs::path& file) {
    for (size_t i = 0; i < state.outer.size(); ++i)
        if (is_same_file(state.outer[i].path, file)) return circle(state, i);
    if (is_same_file(state.path, file)) return circle(state, state.outer.size());
    std::error_code ignored;
    const std::string name(*node.subgraph());
    if (!fs::exists(file, ignored))
        return node.id + ": " + name + " was not found. It is looked for next to " +
               state.file_name() + ".";
    if (!fs::is_regular_file(file, ignored)) return node.id + ": " + name + " is not a file.";
    return {};
}

}  // namespace

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored);
}

const Node* selected_group(const State& state) {
    const Node* node = state.view.selected.size() == 1
                           ? state.document().find(*state.view.selected.begin())
                           : nullptr;
    return node && node->subgraph() ? node : nullptr;
}

void open_group(State& state) {
    const Node* node = selected_group(state);
    if (!node) {
        state.status = "Select one node that is a sub-graph.";
        return;
    }
    const fs::path file = (state.folder() / fs::path(*node->subgraph())).lexically_normal();
    const std::string why = why_not_opened(state, *node, file);
    if (!why.empty()) {
        state.status = why;
        return;
    }
    enter_subgraph(state, file);
    look_for_recoverable(state);
    offer_recovery(state);
}

void enter_subgraph(State& state, const fs::path& file) {
    if (state.dirty()) keep_edits_now(state);
    Level level;
    exchange(state, level);
    const PreviewView seen = level.view.preview_view;
    state.outer.push_back(std::move(level));
    load_file(state, file);
    state.view.preview_view = seen;
}

void leave_subgraphs(State& state, size_t depth) {
    if (depth >= state.outer.size()) return;
    state.keeping.journal.drop();
    for (size_t i = depth + 1; i < state.outer.size(); ++i)
        state.outer[i].journal.drop();
    exchange(state, state.outer[depth]);
    state.outer.resize(depth);
    reset_interaction(state);
    state.keeping.looked = 0;
    state.status = "Back in " + state.file_name();
}

void close_outer(State& state) {
    for (Level& level : state.outer)
        level.journal.drop();
    state.outer.clear();
}

std::vector<std::string> unsaved(const State& state, const PendingAction& intent) {
    const std::vector<std::string> files = open_files(state);
    std::vector<std::string> names;
    size_t kept = 0;  // number of outermost levels that stay open
    if (intent.kind == PendingAction::Kind::nothing) kept = files.size();
    if (intent.kind == PendingAction::Kind::leave) kept = intent.depth + 1;
    for (size_t i = files.size(); i-- > kept;)
        if (i < state.outer.size() ? state.outer[i].dirty() : state.dirty())
            names.push_back(files[i]);
    return names;
}

std::vector<std::string> open_files(const State& state) {
    std::vector<std::string> names;
    for (const Level& level : state.outer)
        names.push_back(file_name_of(level.path));
    names.push_back(state.file_name());
    return names;
}

}  // namespace wrinkle::editor
