// What making a layout and bringing one up to a change have in common; for these two alone.
#pragma once

#include <functional>

#include "editor/canvas/layout.h"

namespace wrinkle::editor {

// What two layouts compare to see whether other outputs of a node are read: a sum over its readers.
inline uint64_t reader_key(std::string_view port) {
    return std::hash<std::string_view>{}(port);
}

Extent box_of(const Card& card);
void find_bounds(Layout& layout);

// A wire between two cards, nothing where one of them has no such pin. Types, conversion, ends and
// box follow from the cards by fit_wire().
std::optional<Wire> make_wire(const Layout& layout, const Link& from, uint32_t source,
                              uint32_t reader, const std::string& port);
void fit_wire(const Layout& layout, Wire& wire, Extent& box);

// Brings the layout up to the document where little has changed: some nodes at most, and nothing at
// the borders. False, with the layout as it was, where it has to be made anew.
bool patch_layout(State& state);

}  // namespace wrinkle::editor
