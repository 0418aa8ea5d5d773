// Gestures of frames and notes: resized at their edges, moved with the cards' gesture (move.cpp).
#include <algorithm>
#include <cmath>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/canvas/layout.h"

namespace wrinkle::editor {
namespace {

constexpr double min_width = 64, min_height = 40;

double on_grid(double length) {
    return std::round(length / 8) * 8;
}

}  // namespace

void select_box(CanvasState& canvas, const BoxId& id) {
    const ImGuiIO& io = ImGui::GetIO();
    std::set<BoxId>& boxes = canvas.view.boxes;
    if (io.KeyShift || io.KeyCtrl) {
        if (!boxes.erase(id)) boxes.insert(id);
    } else if (!boxes.contains(id)) {
        boxes = {id};
        canvas.view.selected.clear();
    }
}

void click_box(CanvasState& canvas, const BoxId& id) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl) return;
    canvas.view.boxes = {id};
    canvas.view.selected.clear();
}

void begin_box(State& state, const Hit& hit) {
    const BoxId id = all_boxes(state.document())[hit.part];
    select_box(state, id);
    begin_gesture(state, hit.edges != 0 ? Gesture::Kind::resize : Gesture::Kind::move);
    Gesture& g = state.gesture;
    g.box = id;
    g.edges = hit.edges;
    g.rect = find_box(state.document(), id)->rect;
    carry_selection(state);
    if (g.kind == Gesture::Kind::move) add_contents(state, id, g.carried, g.carried_boxes);
}

void drag_resize(State& state, ImVec2 delta) {
    const Gesture& g = state.gesture;
    const Box* found = find_box(state.document(), g.box);
    if (!found) return;
    Box box = *found;
    const double dx = delta.x / state.view.zoom, dy = delta.y / state.view.zoom;
    double left = g.rect.x, right = left + g.rect.width;
    double top = g.rect.y, bottom = top + g.rect.height;
    if (g.edges & 1) left = std::min(on_grid(left + dx), right - min_width);
    if (g.edges & 2) right = std::max(on_grid(right + dx), left + min_width);
    if (g.edges & 4) top = std::min(on_grid(top + dy), bottom - min_height);
    if (g.edges & 8) bottom = std::max(on_grid(bottom + dy), top + min_height);
    box.rect = {left, top, right - left, bottom - top};
    state.commit(g.box.note ? "Resize note" : "Resize frame",
                 with_box(state.document(), g.box.note, std::move(box)), g.merge);
}

}  // namespace wrinkle::editor
