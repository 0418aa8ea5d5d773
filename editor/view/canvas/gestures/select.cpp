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

}  // namespace

void select_card(CanvasState& canvas, const std::string& id) {
    std::set<std::string>& selected = canvas.view.selected;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl) {
        if (!selected.erase(id)) selected.insert(id);
    } else if (!selected.contains(id)) {
        selected = {id};
        canvas.view.boxes.clear();
    }
    std::erase(canvas.view.order, id);
    canvas.view.order.push_back(id);
    canvas.layout_stale = true;
}

void click_card(CanvasState& canvas, const std::string& id) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl) return;
    canvas.view.selected = {id};
    canvas.view.boxes.clear();
}

void drag_box(State& state) {
    const ImGuiIO& io = ImGui::GetIO();
    const Gesture& g = state.gesture;
    const Extent box =
        Extent::between(to_canvas(state.view, g.start), to_canvas(state.view, io.MousePos));
    const bool keep = io.KeyShift || io.KeyCtrl;
    state.view.selected = keep ? g.selected : std::set<std::string>();
    state.view.boxes = keep ? g.boxes : std::set<BoxId>();
    for (const Card& card : state.layout.cards) {
        if (!box.touches(card.extent())) continue;
        if (io.KeyCtrl)
            state.view.selected.erase(card.id);
        else
            state.view.selected.insert(card.id);
    }
    for (const BoxId& id : all_boxes(state.document())) {
        if (!box.contains(extent_of(state, id, *find_box(state.document(), id)))) continue;
        if (io.KeyCtrl)
            state.view.boxes.erase(id);
        else
            state.view.boxes.insert(id);
    }
}

void drag_lasso(CanvasState& canvas) {
    if (!follow_stroke(canvas)) return;
    const Gesture& g = canvas.gesture;
    canvas.view.selected = g.selected;
    for (const Card& card : canvas.layout.cards)
        if (encloses(g.stroke, card.at + card.size * 0.5F)) canvas.view.selected.insert(card.id);
}

}  // namespace wrinkle::editor
