#include "editor/model/hosts/kept_exports.h"

#include <algorithm>

#include "editor/model/hosts/host_export.h"

namespace wrinkle::editor {
namespace {

// The graph may have become a parent of the current one while it was exported.
void note_done(Session& session, const std::filesystem::path& path) {
    const auto note = [&](OpenGraph& graph) {
        if (graph.path != path) return;
        ++graph.kept_exports.done;
        graph.kept_exports.written = std::time(nullptr);
    };
    note(session);
    std::ranges::for_each(session.parent_graphs, note);
}

}  // namespace

void keep_exported(Session& session, const HostChoices& choices, bool kept) {
    std::vector<HostChoices>& chosen = session.kept_exports.chosen;
    std::erase_if(chosen, [&](const HostChoices& each) { return each.host == choices.host; });
    if (kept) chosen.push_back(choices);
}

const HostChoices* find_kept_export(const Session& session, const Host& host) {
    const std::vector<HostChoices>& chosen = session.kept_exports.chosen;
    const auto found = std::ranges::find(chosen, &host, &HostChoices::host);
    return found == chosen.end() ? nullptr : &*found;
}

void poll_kept_exports(Session& session) {
    KeptExports& kept = session.kept_exports;
    if (kept.due.empty() || session.tasks.running || !session.is_synced) return;
    const HostChoices next = kept.due.front();
    kept.due.erase(kept.due.begin());
    ++kept.begun;
    start_host_export(session, next,
                      [path = session.path](Session& after) { note_done(after, path); });
}

KeptState state_of_kept(const Session& session) {
    const KeptExports& kept = session.kept_exports;
    if (!kept.due.empty()) return KeptState::waiting;
    if (kept.begun > kept.done)
        return session.tasks.running ? KeptState::waiting : KeptState::failed;
    return kept.written ? KeptState::written : KeptState::none;
}

std::string words_on_kept(const Session& session) {
    switch (state_of_kept(session)) {
        case KeptState::none:
            return {};
        case KeptState::waiting:
            return "Exporting";
        case KeptState::failed:
            return "Not exported";
        case KeptState::written:
            break;
    }
    char text[40] = "Exported";
    if (const tm* local = std::localtime(&session.kept_exports.written))
        std::strftime(text, sizeof text, "Exported %H:%M", local);
    return text;
}

}  // namespace wrinkle::editor
