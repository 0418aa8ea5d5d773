// Files dropped on the window, by what they are and where they fall:
//
//   a picture on empty ground     a source node; shown when the graph has no output `normal` yet
//   a picture on a wire           its bump is laid over the one on the wire
//   a picture on a node with one  replaces the picture that it reads
//   a mesh, or an HDR picture on the preview   for the preview
//   a graph                       is opened
//
// The second of several pictures is laid over the first. A picture outside the graph's folder can
// only be read after it was copied into it, which is offered.
#pragma once

#include "editor/state.h"

namespace wrinkle::editor {

// At the end of a frame, when everything on the screen has its name.
void handle_drops(State& state);

// The question whether files from elsewhere are to be copied into the graph's folder.
void draw_copy_question(State& state);

}  // namespace wrinkle::editor
