// Keeping the unsaved edits of the open document in its journal, and getting back those of a
// program that died.
#pragma once

#include "editor/document/journal.h"

namespace wrinkle::editor {

struct State;

// Once a frame, after its edits: all that is committed is on disk when it returns. Steps of a drag
// follow at its end.
void keep_edits(State& state);
// At once, whatever the hand is doing. False when they could not be kept, or nothing ever is.
bool keep_edits_now(State& state);

// What can be said of it: "Saved", "All edits kept 14:02"; "" for a new graph.
std::string kept_words(const State& state);

// Fills state.keeping.recoverable.
void look_for_recoverable(State& state);
// Asks about the latest for the open graph; where there is no file, about the latest of all.
void offer_recovery(State& state);
// Opens its graph and commits what was unsaved, so that undo shows the file.
void recover(State& state, const Recoverable& found);
// Its edits are given up.
void forget(State& state, const Recoverable& found);

}  // namespace wrinkle::editor
