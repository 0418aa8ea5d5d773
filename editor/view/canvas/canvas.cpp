#include "editor/view/canvas/canvas.h"

#include <algorithm>
#include <cmath>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/card_names.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/panels/panels.h"
#include "editor/view/refresh.h"

namespace wrinkle::editor {
namespace {

using Kind = Gesture::Kind;

constexpr float threshold = 4;  // pixels before a press becomes a drag

void toggle_more(CanvasState& canvas, const Card& card) {
    View& view = canvas.view;
    if (card.kind == Card::Kind::node) {
        if (view.unfolded.erase(card.id) == 0) view.unfolded.insert(card.id);
    } else {
        bool& all = card.kind == Card::Kind::surface ? view.all_surface : view.all_outputs;
        all = !all;
    }
    canvas.layout_stale = true;
}

// Double-click: the name is renamed in place; the rest of a sub-graph's card opens the sub-graph.
bool is_on_name(const CanvasState& canvas, const Card& card) {
    const ImVec2 at = to_canvas(canvas.view, ImGui::GetIO().MousePos) - card.at;
    return at.y < header_height && at.x < name_left + card.name_width + 4;
}

void double_click(State& state, const Hit& hit) {
    if (hit.kind == Hit::Kind::wire) {
        reroute_wire(state, hit.part, to_canvas(state.view, ImGui::GetIO().MousePos));
        return;
    }
    if (hit.kind == Hit::Kind::box) {
        edit_box_text(state, all_boxes(state.document())[hit.part]);
        return;
    }
    if (!hit.on_card(state.layout)) return;
    const Card& card = state.layout.cards[hit.card];
    const Node* node = state.document().find(card.id);
    if ((hit.kind == Hit::Kind::card || hit.kind == Hit::Kind::header) && node &&
        node->subgraph() && !is_on_name(state, card)) {
        state.view.selected = {card.id};
        open_selected_group(state);
    } else if (hit.kind == Hit::Kind::header && card.kind == Card::Kind::node) {
        open_popup(state, card, nullptr, Popup::Kind::rename);
    } else if (hit.kind == Hit::Kind::field && card.fields[hit.part].lanes > 0 &&
               card.fields[hit.part].shows == Field::Shows::value) {
        open_popup(state, card, &card.fields[hit.part], Popup::Kind::text);
    }
}

void press(State& state, const Hit& hit) {
    const ImGuiIO& io = ImGui::GetIO();
    state.view.selected_wire.reset();
    if (io.KeyAlt) return begin_gesture(state, Kind::pan);
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) double_click(state, hit);
    if (!state.layout.nodes.same(state.document().nodes)) return;  // the hit is in another graph
    if (state.popup.kind != Popup::Kind::none || state.box_text.open) return;
    const Card* card = hit.on_card(state.layout) ? &state.layout.cards[hit.card] : nullptr;
    switch (hit.kind) {
        case Hit::Kind::pin:
            return begin_wire(state, *card, card->pins[hit.part]);
        case Hit::Kind::field:
            return begin_value(state, *card, card->fields[hit.part]);
        case Hit::Kind::header:
        case Hit::Kind::card:
            return begin_move(state, card->id);
        case Hit::Kind::more:
            return toggle_more(state, *card);
        case Hit::Kind::wire: {
            const Wire& wire = state.layout.wires[hit.part];
            state.view.selected.clear();
            state.view.selected_wire = Link{wire.node, wire.port};
            return;
        }
        case Hit::Kind::box:
            return begin_box(state, hit);
        case Hit::Kind::nothing:
            begin_gesture(state, io.KeyCtrl && io.KeyShift ? Kind::lasso : Kind::box);
            if (io.KeyShift || io.KeyCtrl) return;
            state.view.selected.clear();
            state.view.boxes.clear();
            return;
    }
}

constexpr float margin = 20, fastest = 900;  // screen pixels; screen pixels per second

float push(float at, float low, float high) {
    const float before = low + margin - at, after = at - (high - margin);
    return std::clamp(before, 0.0F, 2 * margin) - std::clamp(after, 0.0F, 2 * margin);
}

// Pans the view while the pointer is near the border of the canvas.
void pan_at_edges(CanvasState& canvas) {
    Gesture& g = canvas.gesture;
    const ImGuiIO& io = ImGui::GetIO();
    g.panning = false;
    if (!g.moved || g.kind == Gesture::Kind::pan || g.kind == Gesture::Kind::value) return;
    if (!ImGui::IsMousePosValid()) return;
    const View& view = canvas.view;
    const ImVec2 end = view.corner + view.extent;
    const ImVec2 by = ImVec2(push(io.MousePos.x, view.corner.x, end.x),
                             push(io.MousePos.y, view.corner.y, end.y)) *
                      (fastest * io.DeltaTime / (2 * margin));
    if (by.x == 0 && by.y == 0) return;
    g.panning = true;
    g.start = g.start + by;
    canvas.view.pan = canvas.view.pan + by;
}

void drag_view(State& state, ImVec2) {
    state.view.pan = state.view.pan + ImGui::GetIO().MouseDelta;
}

// A wire that is dragged onto the row of folded ports shows them.
void unfold_under_wire(State& state, ImVec2) {
    const Hit hit = pick(state, ImGui::GetIO().MousePos);
    if (hit.kind != Hit::Kind::more) return;
    const Card& card = state.layout.cards[hit.card];
    if (card.kind == Card::Kind::node && !card.unfolded) toggle_more(state, card);
}

// Functions for each motion and for the release of the button, by Gesture::Kind.
struct GestureSteps {
    void (*drag)(State&, ImVec2 delta) = nullptr;
    void (*drop)(State&) = nullptr;
};
constexpr GestureSteps steps_of[] = {
    {},
    {drag_view},
    {drag_box},
    {drag_move, drop_cards},
    {unfold_under_wire, drop_wire},
    {drag_value, drop_value},
    {drag_stroke, drop_cut},
    {drag_stroke, drop_reroutes},
    {nullptr, drop_lazy},
    {drag_lasso},
    {drag_resize},
};
static_assert(std::size(steps_of) == static_cast<size_t>(Kind::resize) + 1);

void drag(State& state) {
    Gesture& g = state.gesture;
    const ImGuiIO& io = ImGui::GetIO();
    pan_at_edges(state);
    if (!ImGui::IsMousePosValid()) return;  // outside the window
    const ImVec2 delta = io.MousePos - g.start;
    if (!g.moved && std::fabs(delta.x) < threshold && std::fabs(delta.y) < threshold) return;
    if (!g.moved && g.kind == Kind::wire) lift_wire(state);
    g.moved = true;
    if (const auto drag = steps_of[static_cast<size_t>(g.kind)].drag) drag(state, delta);
}

void release(State& state) {
    if (const auto drop = steps_of[static_cast<size_t>(state.gesture.kind)].drop) drop(state);
    state.gesture = {};
    state.layout_stale = true;
}

void cancel(State& state) {
    if (state.gesture.moved) state.history.cancel(state.gesture.merge);
    state.view.pan = state.gesture.pan;
    if (state.gesture.kind == Kind::box || state.gesture.kind == Kind::lasso) {
        state.view.selected = state.gesture.selected;
        state.view.boxes = state.gesture.boxes;
    }
    state.status.clear();
    state.gesture = {};
    state.layout_stale = true;
}

// Returns true for gestures that store layout indices of cards or wires.
bool points_at_layout(const Gesture& g) {
    return g.kind == Kind::cut || g.kind == Kind::reroute || g.kind == Kind::lazy ||
           g.kind == Kind::move;
}

void zoom_by_wheel(CanvasState& canvas) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseWheel != 0)
        zoom_at(canvas.view, canvas.layout, io.MousePos, std::pow(1.1F, io.MouseWheel));
}

void press_right(State& state, const Hit& hit) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl) return begin_gesture(state, Kind::cut, 1);
    if (io.KeyShift) return begin_gesture(state, Kind::reroute, 1);
    if (io.KeyAlt && hit.on_card(state.layout)) {
        begin_gesture(state, Kind::lazy, 1);
        state.gesture.card = hit.card;
    } else if (hit.kind == Hit::Kind::nothing && !io.KeyAlt) {
        open_palette(state, io.MousePos, {});
    } else if (!io.KeyAlt) {
        open_context_menu(state, hit, io.MousePos);
    }
}

// Shows the name of a small card in a tooltip if the canvas does not show it in full.
void explain_small_card(State& state) {
    const Hit& hit = state.hovered;
    if (!hit.on_card(state.layout) || state.view.zoom >= plain_zoom) return;
    const Card& card = state.layout.cards[hit.card];
    for (const CardName& name : card_names(state))
        if (name.card == hit.card && !name.cut) return;
    const std::string& name = card.kind == Card::Kind::outputs ? card.name : card.id;
    show_tooltip(about_hit(state, {Hit::Kind::card, hit.card}), state.fonts.bold(16), name,
                 card.label);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    state.targets.add("tip:" + card.id, {mouse.x, mouse.y, mouse.x, mouse.y});
}

}  // namespace

void begin_gesture(State& state, Gesture::Kind kind, int button) {
    state.gesture = {};
    state.gesture.kind = kind;
    state.gesture.button = button;
    state.gesture.serial = state.history.serial();
    state.gesture.pan = state.view.pan;
    state.gesture.selected = state.view.selected;
    state.gesture.boxes = state.view.boxes;
    state.gesture.start = ImGui::GetIO().MousePos;
    state.gesture.merge = "gesture " + std::to_string(state.history.serial());
}

void update_gesture(State& state, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    const Gesture& g = state.gesture;
    if (points_at_layout(g) && g.serial != state.history.serial()) cancel(state);
    state.hovered = g.kind == Kind::wire              ? snap_wire(state, io.MousePos)
                    : hovered || g.kind != Kind::none ? pick(state, io.MousePos)
                                                      : Hit{};
    if (g.kind == Kind::none && hovered) {
        zoom_by_wheel(state);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) press(state, state.hovered);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) begin_gesture(state, Kind::pan, 2);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Right)) press_right(state, state.hovered);
    } else if (g.kind != Kind::none) {
        drag(state);
        if (ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_Escape], false))
            cancel(state);
        else if (!io.MouseDown[g.button])
            release(state);
    }
}

void show_nodes(State& state, bool selection_only) {
    Pane& maximised = state.panes.maximised;
    if (maximised != Pane::canvas) maximised = Pane::none;
    state.view.extent = regions_of(state).canvas.size;
    fit(state.view, state.layout, selection_only);
}

void draw_canvas(State& state) {
    View& view = state.view;
    view.corner = ImGui::GetCursorScreenPos();
    keep_in_sight(state, ImGui::GetContentRegionAvail());
    view.extent = ImGui::GetContentRegionAvail();
    press_area("canvas", view.extent,
               ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                   ImGuiButtonFlags_MouseButtonRight);
    update_gesture(state, ImGui::IsItemHovered());
    refresh(state);
    if (!view.fitted && view.extent.x > 0) {
        fit(view, state.layout, false);
        view.fitted = true;
    }
    reveal_new(state);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(view.corner, view.corner + view.extent, true);
    draw_graph(state, list);
    draw_gesture(state, list);
    list.PopClipRect();
    explain_small_card(state);
    name_targets(state);
    name_boxes(state);
}

}  // namespace wrinkle::editor
