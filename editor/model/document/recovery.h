// Journals the unsaved edits of the open document, and recovers those of a crashed program.
#pragma once

#include "editor/model/document/journal.h"

namespace wrinkle::editor {

struct State;

// Called once a frame after its edits; all committed edits are written when it returns. Steps of a
// drag are written at its end.
void keep_edits(State& state);
// Writes at once, even during a drag. Returns false on an error or if there is no state folder.
bool keep_edits_now(State& state);

// Text for the status bar: "Saved", "All edits kept 14:02"; "" for a new graph.
std::string kept_words(const State& state);

// Fills state.keeping.recoverable.
void look_for_recoverable(State& state);
// Prompts for the latest journal of the open graph; if it has no file, for the latest of all.
void offer_recovery(State& state);
// Opens its graph and commits the unsaved edits, so that undo returns to the file.
void recover(State& state, const Recoverable& found);
// Discards its edits.
void forget(State& state, const Recoverable& found);

}  // namespace wrinkle::editor
