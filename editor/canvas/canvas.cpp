#include "editor/canvas/canvas.h"

#include <cmath>

#include "editor/canvas/gestures/gestures.h"
#include "editor/canvas/layout.h"
#include "editor/document/edits.h"
#include "editor/document/refresh.h"
#include "editor/look/draw.h"

namespace wrinkle::editor {
namespace {

using Kind = Gesture::Kind;

constexpr float threshold = 4;  // pixels before a press becomes a drag

void toggle_more(State& state, const Card& card) {
    bool& all = card.kind == Card::Kind::surface ? state.view.all_surface : state.view.all_outputs;
    all = !all;
    state.layout_stale = true;
}

void double_click(State& state, const Hit& hit) {
    if (hit.kind == Hit::Kind::header) {
        const Card& card = state.layout.cards[hit.card];
        if (card.kind == Card::Kind::node) open_popup(state, card, nullptr, Popup::Kind::rename);
    } else if (hit.kind == Hit::Kind::field) {
        const Card& card = state.layout.cards[hit.card];
        const Field& field = card.fields[hit.part];
        if (field.lanes > 0) open_popup(state, card, &field, Popup::Kind::text);
    }
}

void press(State& state, const Hit& hit) {
    const ImGuiIO& io = ImGui::GetIO();
    state.view.selected_wire.reset();
    if (io.KeyAlt) return begin_gesture(state, Kind::pan);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) double_click(state, hit);
    if (state.popup.kind != Popup::Kind::none) return;
    switch (hit.kind) {
        case Hit::Kind::pin: {
            const Card& card = state.layout.cards[hit.card];
            return begin_wire(state, card, card.pins[hit.part]);
        }
        case Hit::Kind::field: {
            const Card& card = state.layout.cards[hit.card];
            return begin_value(state, card, card.fields[hit.part]);
        }
        case Hit::Kind::header:
        case Hit::Kind::card:
            select_card(state, state.layout.cards[hit.card].id);
            return begin_gesture(state, Kind::move);
        case Hit::Kind::more:
            return toggle_more(state, state.layout.cards[hit.card]);
        case Hit::Kind::wire: {
            const Wire& wire = state.layout.wires[hit.part];
            state.view.selected.clear();
            state.view.selected_wire = Link{wire.node, wire.port};
            return;
        }
        case Hit::Kind::nothing:
            if (!io.KeyShift) state.view.selected.clear();
            return begin_gesture(state, Kind::box);
    }
}

void drag(State& state) {
    Gesture& g = state.gesture;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 delta = io.MousePos - g.start;
    if (!g.moved && std::fabs(delta.x) < threshold && std::fabs(delta.y) < threshold) return;
    if (!g.moved && g.kind == Kind::wire) lift_wire(state);
    g.moved = true;
    switch (g.kind) {
        case Kind::pan:
            state.view.pan = state.view.pan + io.MouseDelta;
            break;
        case Kind::box:
            drag_box(state);
            break;
        case Kind::move:
            drag_move(state, delta);
            break;
        case Kind::value:
            drag_value(state, delta);
            break;
        case Kind::wire:
        case Kind::none:
            break;
    }
}

void release(State& state) {
    const Gesture g = state.gesture;
    switch (g.kind) {
        case Kind::wire:
            drop_wire(state);
            break;
        case Kind::move:
            if (g.moved) drop_cards(state);
            break;
        case Kind::value:
            drop_value(state);
            break;
        default:
            break;
    }
    state.gesture = {};
    state.layout_stale = true;
}

void cancel(State& state) {
    if (state.gesture.moved) state.history.cancel(state.gesture.merge);
    state.gesture = {};
    state.layout_stale = true;
}

void zoom_by_wheel(State& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel != 0) zoom_at(state.view, io.MousePos, std::pow(1.1F, io.MouseWheel));
}

}  // namespace

void begin_gesture(State& state, Gesture::Kind kind) {
    state.gesture = {};
    state.gesture.kind = kind;
    state.gesture.start = ImGui::GetIO().MousePos;
    state.gesture.merge = "gesture " + std::to_string(state.history.serial());
}

void update_gesture(State& state, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    state.hovered = hovered || state.gesture.kind != Kind::none ? pick(state, io.MousePos) : Hit{};
    if (state.gesture.kind == Kind::none && hovered) {
        zoom_by_wheel(state);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press(state, state.hovered);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) begin_gesture(state, Kind::pan);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Right) &&
            state.hovered.kind == Hit::Kind::nothing)
            open_palette(state, io.MousePos, {});
    } else if (state.gesture.kind != Kind::none) {
        drag(state);
        const int button = io.MouseDown[2] || io.MouseReleased[2] ? 2 : 0;
        if (ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_Escape], false))
            cancel(state);
        else if (!io.MouseDown[button])
            release(state);
    }
}

void draw_canvas(State& state) {
    View& view = state.view;
    view.corner = ImGui::GetCursorScreenPos();
    view.extent = ImGui::GetContentRegionAvail();
    if (!view.fitted && view.extent.x > 0) {
        fit(view, state.layout, false);
        view.fitted = true;
    }
    ImGui::InvisibleButton("canvas", view.extent,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                               ImGuiButtonFlags_MouseButtonRight);
    update_gesture(state, ImGui::IsItemHovered());
    refresh(state);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(view.corner, view.corner + view.extent, true);
    draw_graph(state, list);
    list.PopClipRect();
    name_targets(state);
}

}  // namespace wrinkle::editor
