#include <algorithm>

#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

using Gestures = Gesture::Kind;

// Hints by the kind of a gesture or of the element under the pointer.
template <class Kind>
struct Hint {
    Kind kind;
    std::string_view text;
};
constexpr Hint<Gestures> gesture_hints[] = {
    {Gestures::wire,
     "Drop on a pin, or on empty ground for a node that fits   Esc to drop the wire"},
    {Gestures::value, "Ctrl is fine, Shift coarse   Esc gives the value back"},
    {Gestures::move, "Esc puts it back"},
    {Gestures::box, "Shift adds to the selection   Ctrl takes away"},
    {Gestures::lasso, "Shift adds to the selection   Ctrl takes away"},
    {Gestures::cut, "Wires under the stroke are cut when the button is let go   Esc keeps them"},
    {Gestures::reroute, "Wires under the stroke get a reroute when the button is let go"},
    {Gestures::lazy, "Release on a node to connect the best fit   Esc to drop the wire"},
    {Gestures::resize, "Esc gives the size back"},
    {Gestures::pan, "Let go where it shall stay"},
};

constexpr Hint<Hit::Kind> canvas_hints[] = {
    {Hit::Kind::pin, "Drag to connect"},
    {Hit::Kind::field, "Drag to change   double-click to type   E exposes it"},
    {Hit::Kind::header, "Drag to move   double-click to rename"},
    {Hit::Kind::card, "Drag to move"},
    {Hit::Kind::wire, "Click to select   double-click to bend   Delete removes it"},
};

template <class Kind>
std::string_view find_hint(std::span<const Hint<Kind>> hints, Kind kind) {
    const auto found = std::ranges::find(hints, kind, &Hint<Kind>::kind);
    return found == hints.end() ? "" : found->text;
}

// By Popup::Kind.
constexpr std::string_view popup_hints[] = {
    "",
    "Enter takes it   Tab moves to the next value   Esc leaves it",
    "Enter renames   Esc leaves the name",
    "Up and Down choose   Enter takes it   Esc leaves it",
    "Type to narrow the list   Enter takes it   Esc leaves it",
    "Drag in the field   Esc closes",
    "Up and Down choose   Enter exposes it   Esc closes",
    "Click the strip to add   Left and Right select   Shift moves   Del removes   Esc closes",
    "Click to add   Left and Right select   Shift and arrows move   Del removes   Esc closes",
};
static_assert(std::size(popup_hints) == static_cast<size_t>(Popup::Kind::curve) + 1);

constexpr Hint<Palette::List> list_hints[] = {
    {Palette::List::nodes, "Enter shows the node   Esc closes"},
    {Palette::List::commands, "Enter runs it   Esc closes"},
    {Palette::List::steps, "Enter returns to the step   Esc closes"},
};

std::string_view hint_of_gesture(const Gesture& gesture) {
    if (gesture.under_wire) return "Let go to put it in this wire   Esc puts it back";
    return find_hint<Gestures>(gesture_hints, gesture.kind);
}

std::string_view hint_of_open(const Dialogs& open) {
    if (open.eyedropper.on) return "Click takes the color   Esc returns to the picker";
    if (open.palette.open && open.palette.list != Palette::List::types)
        return find_hint<Palette::List>(list_hints, open.palette.list);
    if (open.palette.open && open.palette.wire.kind == Gestures::wire)
        return "Pick a node to place it on the wire   Esc to drop the wire";
    if (open.palette.open) return "Pick a node to place it   Esc closes";
    if (open.offer.open) return "Enter takes the first   Esc to drop the wire";
    if (open.box_text.open) return "Enter ends   Ctrl+Enter is a new line";
    return popup_hints[static_cast<size_t>(open.popup.kind)];
}

std::string_view hint_of_canvas(const Hit& hovered) {
    const std::string_view hint = find_hint<Hit::Kind>(canvas_hints, hovered.kind);
    return hint.empty() ? "Space adds a node   the wheel zooms   the middle button pans" : hint;
}

}  // namespace

std::string_view hint_of(const State& state, const Regions& regions) {
    if (const std::string_view hint = hint_of_gesture(state.gesture); !hint.empty()) return hint;
    if (const std::string_view hint = hint_of_open(state); !hint.empty()) return hint;
    if (state.question.open() || state.browser.purpose != Browser::Purpose::none) return {};
    switch (regions.at(ImGui::GetIO().MousePos)) {
        case Pane::preview:
            return state.view.flat.on
                       ? "Drag moves   the wheel zooms   7 returns to the object"
                       : "Drag turns   Shift+drag moves   the right button turns the light";
        case Pane::code:
            return state.inputs_panel.shown ? "Drag to change   ... types a value"
                                            : "Click a line to select its node";
        case Pane::problems:
            return "Click a problem to show its node";
        case Pane::canvas:
        case Pane::none:
            break;
    }
    if (is_at_start(state)) return "Drop an image, or open a sample with a click";
    return hint_of_canvas(state.hovered);
}

}  // namespace wrinkle::editor
