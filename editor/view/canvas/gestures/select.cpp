#include "editor/view/canvas/gestures/gestures.h"

#include <algorithm>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

// Returns true if `at` is inside the polygon (even-odd rule).
bool encloses(const std::vector<ImVec2>& polygon, ImVec2 at) {
    bool inside = false;
    for (size_t i = 0, k = polygon.size() - 1; i < polygon.size(); k = i++) {
        const ImVec2 a = polygon[i], b = polygon[k];
        if ((a.y > at.y) == (b.y > at.y)) continue;
        if (at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
    }
    return inside;
}

bool is_adding() {
    return ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl;
}

template <class Id, class Other>
void select_only(std::set<Id>& ids, std::set<Other>& others, const Id& id) {
    ids = {id};
    others.clear();
}

// Shift or Ctrl toggles; else an item that is not selected becomes the only one.
template <class Id, class Other>
void select(std::set<Id>& ids, std::set<Other>& others, const Id& id) {
    if (!is_adding()) {
        if (!ids.contains(id)) select_only(ids, others, id);
    } else if (!ids.erase(id)) {
        ids.insert(id);
    }
}

}  // namespace

void select_card(CanvasState& canvas, const std::string& id) {
    select(canvas.view.selected, canvas.view.boxes, id);
    std::erase(canvas.view.order, id);
    canvas.view.order.push_back(id);
    canvas.layout_stale = true;
}

void select_box(CanvasState& canvas, const BoxId& id) {
    select(canvas.view.boxes, canvas.view.selected, id);
}

void click_card(CanvasState& canvas, const std::string& id) {
    if (!is_adding()) select_only(canvas.view.selected, canvas.view.boxes, id);
}

void click_box(CanvasState& canvas, const BoxId& id) {
    if (!is_adding()) select_only(canvas.view.boxes, canvas.view.selected, id);
}

void drag_box(State& state, ImVec2) {
    const ImGuiIO& io = ImGui::GetIO();
    const Gesture& g = state.gesture;
    const Extent box =
        Extent::between(to_canvas(state.view, g.start), to_canvas(state.view, io.MousePos));
    state.view.selected = is_adding() ? g.selected : std::set<std::string>();
    state.view.boxes = is_adding() ? g.boxes : std::set<BoxId>();
    const auto enclose = [&](auto& ids, const auto& id) {
        if (io.KeyCtrl)
            ids.erase(id);
        else
            ids.insert(id);
    };
    for (const Card& card : state.layout.cards)
        if (box.touches(card.extent())) enclose(state.view.selected, card.id);
    for (const BoxId& id : all_boxes(state.document()))
        if (box.contains(extent_of(state, id, *find_box(state.document(), id))))
            enclose(state.view.boxes, id);
}

void drag_lasso(State& state, ImVec2) {
    if (!follow_stroke(state)) return;
    const Gesture& g = state.gesture;
    state.view.selected = g.selected;
    for (const Card& card : state.layout.cards)
        if (encloses(g.stroke, card.at + card.size * 0.5F)) state.view.selected.insert(card.id);
}

}  // namespace wrinkle::editor
