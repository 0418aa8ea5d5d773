// One line on what the hand can do now, or with what it is doing: the middle of the status bar.
#pragma once

#include <string_view>

#include "editor/panels/regions.h"

namespace wrinkle::editor {

std::string_view hint_of(const State& state, const Regions& regions);

}  // namespace wrinkle::editor
