// Where wires run, as geometry: what crosses them and what lies under them. Canvas units.
#pragma once

#include <optional>

#include "editor/canvas/card.h"
#include "editor/look/draw.h"

namespace wrinkle::editor {

Curve curve_of(const Wire& wire);

// Where the wire meets the straight line from a to b.
std::optional<ImVec2> crossing(const Layout& layout, size_t wire, ImVec2 a, ImVec2 b);

// The wire that runs under the card nearest to its middle, without those at the card itself.
std::optional<size_t> wire_under(const Layout& layout, const Card& card);

}  // namespace wrinkle::editor
