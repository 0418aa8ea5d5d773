// Geometry of wires: intersection with a segment, wires under a card. Canvas units.
#pragma once

#include <optional>

#include "editor/view/canvas/card.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {

Curve curve_of(const Wire& wire);

// Returns the first intersection of the wire with the segment from a to b; std::nullopt if none.
std::optional<ImVec2> crossing(const Layout& layout, size_t wire, ImVec2 a, ImVec2 b);

// Returns the wire under the card that is nearest to its center, except wires of the card itself.
std::optional<size_t> wire_under(const Layout& layout, const Card& card);

}  // namespace wrinkle::editor
