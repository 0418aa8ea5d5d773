#include "editor/model/hosts/repeated_exports.h"

#include <algorithm>

#include "editor/model/hosts/host_export.h"

namespace wrinkle::editor {
namespace {

// The graph may have become a parent of the current one while it was exported.
void note_done(Session& session, const std::filesystem::path& path) {
    const auto note = [&](OpenGraph& graph) {
        if (graph.path != path) return;
        ++graph.repeated_exports.done;
        graph.repeated_exports.written = std::time(nullptr);
    };
    note(session);
    std::ranges::for_each(session.parent_graphs, note);
}

}  // namespace

void repeat_export(Session& session, const HostChoices& choices, bool on) {
    std::vector<HostChoices>& chosen = session.repeated_exports.chosen;
    std::erase_if(chosen, [&](const HostChoices& each) { return each.host == choices.host; });
    if (on) chosen.push_back(choices);
}

const HostChoices* find_repeated_export(const Session& session, const Host& host) {
    const std::vector<HostChoices>& chosen = session.repeated_exports.chosen;
    const auto found = std::ranges::find(chosen, &host, &HostChoices::host);
    return found == chosen.end() ? nullptr : &*found;
}

void poll_repeated_exports(Session& session) {
    RepeatedExports& repeated = session.repeated_exports;
    if (repeated.due.empty() || session.tasks.running || !session.is_synced) return;
    const HostChoices next = repeated.due.front();
    repeated.due.erase(repeated.due.begin());
    ++repeated.begun;
    start_host_export(session, next,
                      [path = session.path](Session& after) { note_done(after, path); });
}

RepeatState state_of_repeats(const Session& session) {
    const RepeatedExports& repeated = session.repeated_exports;
    if (!repeated.due.empty()) return RepeatState::waiting;
    if (repeated.begun > repeated.done)
        return session.tasks.running ? RepeatState::waiting : RepeatState::failed;
    return repeated.written ? RepeatState::written : RepeatState::none;
}

std::string words_on_repeats(const Session& session) {
    switch (state_of_repeats(session)) {
        case RepeatState::none:
            return {};
        case RepeatState::waiting:
            return "Exporting";
        case RepeatState::failed:
            return "Not exported";
        case RepeatState::written:
            break;
    }
    char text[40] = "Exported";
    if (const tm* local = std::localtime(&session.repeated_exports.written))
        std::strftime(text, sizeof text, "Exported %H:%M", local);
    return text;
}

}  // namespace wrinkle::editor
