// Shared by the popups of color ramps and curves: the edited node, its selected stop or point, and
// the keys. Each gesture is one undo step.
#pragma once

#include <imgui.h>

#include "editor/model/document/knots.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {

struct KnotEditor {
    State& state;
    const Card& card;
    NodePtr node;  // edits replace the node of the document
    RepeatedPorts ports;

    size_t selected() const { return state.popup.knot; }
    size_t count() const { return ports.count_in(*node); }
    void select(size_t knot) const { state.popup.knot = knot; }
    void commit(Document document) const;
    bool has_wire(std::string_view name) const;  // the port of the selected knot
    // Return true, with a sentence in the status, if that port has a wire or all knots are used.
    bool is_on_wire(std::string_view name) const;
    bool is_full() const;
    void remove_selected() const;
};

// Begins a frame of the popup; std::nullopt if it is to be closed. `ports_of` finds the knots.
std::optional<KnotEditor> edit_knots(State& state, RepeatedPorts (*ports_of)(const NodeType*));
// Ends the frame; returns true if the popup is to be closed.
bool end_knots(State& state);

// Draws "Stop 2 of 4" and the buttons `Add` and `Remove`; returns true if one is to be added.
bool draw_knot_buttons(const KnotEditor& editor, const char* name, const std::string& target);

inline constexpr double knot_step = 0.01;  // of a key

struct KnotKeys {
    ImVec2 move{0, 0};  // steps right and up
    bool add = false;
};
// Reads the keys; those that select and remove take effect at once.
KnotKeys read_knot_keys(const KnotEditor& editor);

}  // namespace wrinkle::editor
