#include "editor/model/document/levels.h"

#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

// Swaps the current graph and `graph`.
void exchange(Session& session, OpenGraph& graph) {
    std::swap(static_cast<OpenGraph&>(session), graph);
}

// "strap.json > weave.json > strap.json"
std::string circle(const Session& session, size_t from) {
    const std::vector<std::string> files = open_files(session);
    std::string text = files[from] + " holds itself: ";
    for (size_t i = from; i < files.size(); ++i)
        text += files[i] + " > ";
    return text + files[from] + ".";
}

std::string why_not_opened(const Session& session, const Node& node, const fs::path& file) {
    for (size_t i = 0; i < session.parent_graphs.size(); ++i)
        if (is_same_file(session.parent_graphs[i].path, file)) return circle(session, i);
    if (is_same_file(session.path, file)) return circle(session, session.parent_graphs.size());
    std::error_code ignored;
    const std::string name(*node.subgraph());
    if (!fs::exists(file, ignored))
        return node.id + ": " + name + " was not found. It is looked for next to " +
               session.file_name() + ".";
    if (!fs::is_regular_file(file, ignored)) return node.id + ": " + name + " is not a file.";
    return {};
}

void enter_subgraph(Session& session, const fs::path& file) {
    if (session.dirty()) keep_edits_now(session);
    OpenGraph parent;
    exchange(session, parent);
    session.parent_graphs.push_back(std::move(parent));
    load_file(session, file);
    reset_derived(session, GraphSwitch::entered);
}

}  // namespace

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code ignored;
    return fs::equivalent(a, b, ignored);
}

void open_group(Session& session, const Node& node) {
    const fs::path file = (session.folder() / fs::path(*node.subgraph())).lexically_normal();
    const std::string why = why_not_opened(session, node, file);
    if (!why.empty()) {
        session.status = why;
        return;
    }
    enter_subgraph(session, file);
    look_for_recoverable(session);
    offer_recovery(session);
}

void leave_subgraphs(Session& session, size_t depth) {
    if (depth >= session.parent_graphs.size()) return;
    session.recovery_file.remove();
    for (size_t i = depth + 1; i < session.parent_graphs.size(); ++i)
        session.parent_graphs[i].recovery_file.remove();
    exchange(session, session.parent_graphs[depth]);
    session.parent_graphs.resize(depth);
    reset_derived(session, GraphSwitch::left);
    session.keeping.checked_at = 0;
    session.status = "Back in " + session.file_name();
}

void close_outer(Session& session) {
    for (OpenGraph& parent : session.parent_graphs)
        parent.recovery_file.remove();
    session.parent_graphs.clear();
}

std::vector<std::string> unsaved(const Session& session, const PendingAction& intent) {
    const std::vector<std::string> files = open_files(session);
    std::vector<std::string> names;
    size_t kept = 0;  // number of outermost levels that stay open
    if (intent.kind == PendingAction::Kind::nothing) kept = files.size();
    if (intent.kind == PendingAction::Kind::leave) kept = intent.depth + 1;
    for (size_t i = files.size(); i-- > kept;)
        if (i < session.parent_graphs.size() ? session.parent_graphs[i].dirty() : session.dirty())
            names.push_back(files[i]);
    return names;
}

std::vector<std::string> open_files(const Session& session) {
    std::vector<std::string> names;
    for (const OpenGraph& parent : session.parent_graphs)
        names.push_back(file_name_of(parent.path));
    names.push_back(session.file_name());
    return names;
}

}  // namespace wrinkle::editor
