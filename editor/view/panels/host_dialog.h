// Dialog of an export to a host: three.js, Godot, Blender, glTF ...
#pragma once

#include "editor/view/state.h"

namespace wrinkle::editor {

void open_host_dialog(State& state);

// Returns one sentence on why the current choices cannot be exported now; "" if they can.
std::string why_no_host_export(const State& state);

}  // namespace wrinkle::editor
