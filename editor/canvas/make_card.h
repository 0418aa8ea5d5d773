// A card from its node: rows, pins, fields and the texts on them, in canvas units.
#pragma once

#include <set>
#include <span>

#include "editor/state.h"

namespace wrinkle::editor {

// Whether a node shows what it makes. Usually those do that make another kind of thing than they
// take, so that a chain of operators does not show one picture many times.
bool has_picture(const View& view, const Node& node, const NodeType* type);

// `read` names the outputs that somebody reads, perhaps more than once. The card stands at (0, 0).
Card make_card(const Fonts& fonts, const Node& node, const NodeType* type,
               std::span<const std::string_view> read, bool picture);

// What of the surface and of the graph's inputs is read.
struct Used {
    std::set<std::string_view> surface, inputs;
};
Card make_surface_card(const State& state, const Used& used);
Card make_inputs_card(const State& state, const Used& used);
Card make_outputs_card(const State& state);

}  // namespace wrinkle::editor
