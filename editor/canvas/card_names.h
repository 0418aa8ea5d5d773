// Names of cards that are too small for their headers: below plain_zoom. A name has one size on the
// screen at any zoom. It is in its card where it fits whole, else beside it on free ground, else
// cut to the card; no name covers a card of another node or another name. A card without room for
// three letters has none: the pointer on it shows it. O(cards in sight + pixels).
#pragma once

#include <string>
#include <vector>

#include "editor/state.h"

namespace wrinkle::editor {

inline constexpr float card_name_size = 14;  // screen pixels, of a line

struct CardName {
    size_t card = 0;   // in Layout::cards
    std::string text;  // as it is shown
    bool cut = false;
    bool beside = false;
    ImVec2 low{0, 0}, high{0, 0};  // screen
};
std::vector<CardName> card_names(const State& state);

}  // namespace wrinkle::editor
