// Updates everything derived from the document, in stages with versions (CompileState):
//   edit     the document differs from requested_snapshot: a new model and layout
//   request  a job for the compiler thread: requested_version + 1
//   build    its result: State::built.version, unless it belongs to another file (`first`)
//   preview  the shader is sent, and its problems return: diagnosed_version
// A newer job replaces a waiting one. Cosmetic edits need no build; a value is sent as a uniform.
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

// Updates model and layout to the current snapshot, limited to the changes, and requests a build;
// build and preview follow when the worker threads are done.
void refresh(State& state);

// Returns true while a control of a value is dragged: only its uniform changes, and the build
// follows at the end.
bool is_holding_value(const State& state);

// Returns true if build and preview are those of the current snapshot and no job is pending. While
// the preview moves (preview/play.h) its jobs do not count.
bool is_settled(const State& state);

}  // namespace wrinkle::editor
