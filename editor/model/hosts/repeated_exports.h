// Exports to hosts that are repeated at every save of the graph, one task after the other, until
// another graph is opened.
#pragma once

#include <string>

#include "editor/model/session.h"

namespace wrinkle::editor {

// Repeats the export at every save, instead of one to the same host; or, if not `on`, no longer.
void repeat_export(Session& session, const HostChoices& choices, bool on);

// Returns the choices of the export to the host that is repeated; nullptr if there is none.
const HostChoices* find_repeated_export(const Session& session, const Host& host);

// Called once a frame: starts the next export that is due, while no other task runs.
void poll_repeated_exports(Session& session);

enum class RepeatState : uint8_t { none, waiting, written, failed };
RepeatState state_of_repeats(const Session& session);
// Returns words for the status bar: "Exported 14:02", "Exporting", "Not exported"; "" for none.
std::string words_on_repeats(const Session& session);

}  // namespace wrinkle::editor
