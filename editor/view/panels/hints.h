// One-line hint in the middle of the status bar: available actions, or the current gesture's keys.
#pragma once

#include <string_view>

#include "editor/view/panels/regions.h"

namespace wrinkle::editor {

std::string_view hint_of(const State& state, const Regions& regions);

}  // namespace wrinkle::editor
