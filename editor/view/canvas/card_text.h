// Text styles of a card, shared by measuring and drawing.
#pragma once

#include "editor/view/look/magnified.h"

namespace wrinkle::editor::card_text {

inline constexpr TextStyle body, body_right{16, false, true}, bold{16, true};
inline constexpr TextStyle small{14}, small_right{14, false, true};

}  // namespace wrinkle::editor::card_text
