// Shared by the full layout (layout.cpp) and the incremental update (patch_layout.cpp) only.
#pragma once

#include <functional>

#include "editor/view/canvas/layout.h"

namespace wrinkle::editor {

// Hash of a read output. The sum over a node's readers detects a change of its read outputs.
inline uint64_t reader_key(std::string_view port) {
    return std::hash<std::string_view>{}(port);
}

Extent box_of(const Card& card);
void find_bounds(Layout& layout);

// Returns a wire between two cards; std::nullopt if either has no such pin. fit_wire() derives
// types, conversion, end points and bounding box from the cards.
std::optional<Wire> make_wire(const Layout& layout, const Link& from, uint32_t source,
                              uint32_t reader, const std::string& port);
void fit_wire(const Layout& layout, Wire& wire, Extent& box);

// Updates the layout incrementally if at most 16 nodes changed and nothing changed at the surface,
// inputs and outputs cards. Returns false, with the layout unchanged, if a full layout is needed.
bool patch_layout(State& state);

}  // namespace wrinkle::editor
