// Names of cards at a zoom below plain_zoom, where headers are too small for text. Names have the
// same screen size at any zoom. A name is placed in its card if it fits, else next to it on free
// ground, else truncated in the card. No name covers a card of another node or another name. A card
// without room for three letters gets no name; hovering it shows a tooltip. O(cards + pixels).
#pragma once

#include <string>
#include <vector>

#include "editor/view/state.h"

namespace wrinkle::editor {

inline constexpr float card_name_size = 14;  // line height, screen pixels

struct CardName {
    size_t card = 0;   // in Layout::cards
    std::string text;  // as shown
    bool cut = false;
    bool beside = false;
    ImVec2 low{0, 0}, high{0, 0};  // screen
};
std::vector<CardName> card_names(const State& state);

}  // namespace wrinkle::editor
