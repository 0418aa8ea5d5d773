// Text fields that get keyboard focus when they open. ImGui focuses a field some frames after the
// request; the input queue holds back typed keys until then so that they are not lost.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Requests keyboard focus for the field that is drawn next. Call note_field() after drawing it.
void focus_field(State& state);
void note_field(State& state);  // ends the wait if the last field drawn has focus

// Returns true while an opened field does not have keyboard focus yet. The wait lasts a few frames
// at most, so that keys are delivered even if ImGui does not focus the field.
bool typing_waits(const State& state);
void age_field_wait(State& state);  // once a frame

}  // namespace wrinkle::editor
