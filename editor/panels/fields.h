// Fields that take the keyboard when they open. ImGui gives it to a field frames after it was asked
// to: what is typed in between waits in the input queue, or it would be lost.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

// The field that is drawn next takes the keyboard. After it is drawn: note_field().
void focus_field(State& state);
void note_field(State& state);  // the field that was drawn last may have it

// A field has opened that does not have the keyboard yet. True for few frames at most, so that keys
// come through where ImGui does not give it.
bool typing_waits(const State& state);
void age_field_wait(State& state);  // once a frame

}  // namespace wrinkle::editor
