// Builds a card from its node: rows, pins, fields and their texts, in canvas units.
#pragma once

#include <set>
#include <span>

#include "editor/view/look/magnified.h"
#include "editor/view/state.h"

namespace wrinkle::editor {

// Returns true if the card shows a node preview. By default only nodes with a shown output type
// different from all their input types do, so that a chain of operators does not repeat one
// preview.
bool has_preview(const View& view, const Node& node, const NodeType* type);

// Parts of a card that the view shows.
struct Shown {
    bool preview = false;
    bool unfolded = false;
};
Shown shown_of(const View& view, const Node& node, const NodeType* type);

// A card with more rows than this is folded: it shows the first inputs and outputs and those that
// are connected or set. Stops of ramps and points of curves are always folded unless they are
// connected. Its last row unfolds it.
inline constexpr size_t most_rows = 20, first_rows = 8;

// `read` lists the outputs with a reader, possibly with duplicates. The card is at (0, 0).
Card make_card(const Fonts& fonts, const Node& node, const NodeType* type,
               std::span<const std::string_view> read, Shown shown);

// Surface properties and graph inputs that are read.
struct Used {
    std::set<std::string_view> surface, inputs;
};
Card make_surface_card(const State& state, const Used& used);
Card make_inputs_card(const State& state, const Used& used);
Card make_outputs_card(const State& state);

}  // namespace wrinkle::editor

// Text styles of a card, shared by measuring and drawing.
namespace wrinkle::editor::card_text {

inline constexpr TextStyle body, body_right{16, false, true}, bold{16, true};
inline constexpr TextStyle small{14}, small_right{14, false, true};

}  // namespace wrinkle::editor::card_text
