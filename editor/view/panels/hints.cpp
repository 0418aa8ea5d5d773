#include "editor/view/panels/hints.h"

#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

std::string_view hint_of_gesture(const State& state) {
    switch (state.gesture.kind) {
        case Gesture::Kind::wire:
            return "Drop on a pin, or on empty ground for a node that fits   Esc to drop the wire";
        case Gesture::Kind::value:
            return "Ctrl is fine, Shift coarse   Esc gives the value back";
        case Gesture::Kind::move:
            return state.gesture.under_wire ? "Let go to put it in this wire   Esc puts it back"
                                            : "Esc puts it back";
        case Gesture::Kind::box:
        case Gesture::Kind::lasso:
            return "Shift adds to the selection   Ctrl takes away";
        case Gesture::Kind::cut:
            return "Wires under the stroke are cut when the button is let go   Esc keeps them";
        case Gesture::Kind::reroute:
            return "Wires under the stroke get a reroute when the button is let go";
        case Gesture::Kind::lazy:
            return "Let go on a node to connect what fits best   Esc to drop the wire";
        case Gesture::Kind::resize:
            return "Esc gives the size back";
        case Gesture::Kind::pan:
            return "Let go where it shall stay";
        case Gesture::Kind::none:
            break;
    }
    return {};
}

std::string_view hint_of_open(const State& state) {
    if (state.palette.open && state.palette.commands) return "Enter runs it   Esc closes";
    if (state.palette.open && state.palette.find) return "Enter shows the node   Esc closes";
    if (state.palette.open && state.palette.wire.kind == Gesture::Kind::wire)
        return "Pick a node to place it on the wire   Esc to drop the wire";
    if (state.palette.open) return "Pick a node to place it   Esc closes";
    if (state.offer.open) return "Enter takes the first   Esc to drop the wire";
    if (state.box_text.open) return "Enter ends   Ctrl+Enter is a new line";
    switch (state.popup.kind) {
        case Popup::Kind::text:
            return "Enter takes it   Tab goes on to the next value   Esc leaves it";
        case Popup::Kind::rename:
            return "Enter renames   Esc leaves the name";
        case Popup::Kind::choice:
            return "Up and Down choose   Enter takes it   Esc leaves it";
        case Popup::Kind::file:
            return "Type to narrow the list   Enter takes it   Esc leaves it";
        case Popup::Kind::color:
            return "Drag in the field   Esc closes";
        case Popup::Kind::none:
            break;
    }
    return {};
}

std::string_view hint_of_canvas(const State& state) {
    switch (state.hovered.kind) {
        case Hit::Kind::pin:
            return "Drag to connect";
        case Hit::Kind::field:
            return "Drag to change   double-click to type";
        case Hit::Kind::header:
            return "Drag to move   double-click to rename";
        case Hit::Kind::card:
            return "Drag to move";
        case Hit::Kind::wire:
            return "Click to select   double-click to bend   Delete removes it";
        default:
            return "Space adds a node   the wheel zooms   the middle button pans";
    }
}

}  // namespace

std::string_view hint_of(const State& state, const Regions& regions) {
    if (const std::string_view hint = hint_of_gesture(state); !hint.empty()) return hint;
    if (const std::string_view hint = hint_of_open(state); !hint.empty()) return hint;
    if (state.question.open() || state.browser.purpose != Browser::Purpose::none) return {};
    switch (regions.at(ImGui::GetIO().MousePos)) {
        case Pane::preview:
            return "Drag turns   Shift+drag moves   the right button turns the light";
        case Pane::code:
            return "Click a line to select its node";
        case Pane::problems:
            return "Click a problem to show its node";
        case Pane::canvas:
        case Pane::none:
            break;
    }
    if (is_at_start(state)) return "Drop an image, or open a sample with a click";
    return hint_of_canvas(state);
}

}  // namespace wrinkle::editor
