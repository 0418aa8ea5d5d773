#include "editor/model/document/recovery.h"

#include "base/file.h"
#include "editor/model/document/files.h"
#include "graph/read.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

void say_failure(Session& session, const std::error_code& error) {
    const std::string words = disk_words(error);
    if (session.keeping.unkept != words)
        session.status = "Edits are not kept for recovery: " + words + ". Save them soon.";
    session.keeping.unkept = words;
}

bool same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return real_path(a, error) == real_path(b, error);
}

}  // namespace

bool keep_edits_now(Session& session) {
    Persistence& keeping = session.keeping;
    if (keeping.folders.state.empty()) return false;
    const uint64_t serial = session.history.serial();
    if (session.recovery_file.exists() && session.recovery_serial == serial) return true;
    const fs::path graph = session.path.empty() ? session.folder() / "" : session.path;
    const std::error_code error = session.recovery_file.write(
        keeping.folders.state, graph, session.save_refused, session.document());
    if (error) {
        say_failure(session, error);
        return false;
    }
    keeping.unkept.clear();
    session.recovery_serial = serial;
    keeping.kept_at = std::time(nullptr);
    return true;
}

void keep_edits(Session& session, bool dragging) {
    Persistence& keeping = session.keeping;
    if (!session.dirty()) return session.recovery_file.remove();
    const bool kept =
        session.recovery_file.exists() && session.recovery_serial == session.history.serial();
    if (kept || (session.history.merging() && dragging)) return;
    const bool wait = !keeping.unkept.empty() && !keeping.try_again;
    keeping.try_again = false;
    if (!wait) keep_edits_now(session);
}

std::string kept_words(const Session& session) {
    const Persistence& keeping = session.keeping;
    if (!session.dirty()) return session.path.empty() ? "" : "Saved";
    if (!keeping.unkept.empty()) return "Edits are in memory alone";
    if (!session.recovery_file.exists()) return "Not saved";
    char text[40] = "All edits kept";
    if (const tm* local = std::localtime(&keeping.kept_at))
        std::strftime(text, sizeof text, "All edits kept %H:%M", local);
    return text;
}

void look_for_recoverable(Session& session) {
    session.keeping.recoverable.clear();
    if (!session.keeping.folders.state.empty())
        session.keeping.recoverable = list_recoverable(session.keeping.folders.state);
}

void offer_recovery(Session& session) {
    if (session.question.open()) return;
    for (const Recoverable& found : session.keeping.recoverable) {
        if (!session.path.empty() && !same_file(found.graph, session.path)) continue;
        session.question = {.kind = Question::Kind::recover, .file = found.file};
        return;
    }
}

void recover(Session& session, const Recoverable& found) {
    const Recoverable taken = found;  // forget() rebuilds the list
    // The crashed program may have saved after this one had read the file.
    const bool is_open = !session.path.empty() && same_file(taken.graph, session.path);
    if (taken.graph.empty())
        new_file(session, taken.folder);
    else if (!is_open || session.dirty() || compare(session.disk, session.path) != OnDisk::same)
        open_file(session, taken.graph);
    Diagnostics shown_by_the_build;
    session.commit("Recover unsaved edits",
                   read_document(taken.text, session.path.string(), shown_by_the_build));
    if (!taken.refused.empty()) session.save_refused = taken.refused;
    session.status = "Recovered the unsaved edits of " + session.file_name();
    if (keep_edits_now(session)) forget(session, taken);
}

void forget(Session& session, const Recoverable& found) {
    std::error_code ignored;
    fs::remove(found.file, ignored);
    look_for_recoverable(session);
}

}  // namespace wrinkle::editor
