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

void select_card(State& state, const std::string& id) {
    std::set<std::string>& selected = state.view.selected;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl) {
        if (!selected.erase(id)) selected.insert(id);
    } else if (!selected.contains(id)) {
        selected = {id};
        state.view.boxes.clear();
    }
    std::erase(state.view.order, id);
    state.view.order.push_back(id);
    state.layout_stale = true;
}

void click_card(State& state, const std::string& id) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl) return;
    state.view.selected = {id};
    state.view.boxes.clear();
}

void drag_box(State& state) {
    const ImGuiIO& io = ImGui::GetIO();
    const Gesture& g = state.gesture;
    const ImVec2 a = to_canvas(state.view, g.start), b = to_canvas(state.view, io.MousePos);
    const Extent box{{std::min(a.x, b.x), std::min(a.y, b.y)},
                     {std::max(a.x, b.x), std::max(a.y, b.y)}};
    const bool keep = io.KeyShift || io.KeyCtrl;
    state.view.selected = keep ? g.selected : std::set<std::string>();
    state.view.boxes = keep ? g.boxes : std::set<BoxId>();
    for (const Card& card : state.layout.cards) {
        if (!box.touches({card.at, card.at + card.size})) continue;
        if (io.KeyCtrl)
            state.view.selected.erase(card.id);
        else
            state.view.selected.insert(card.id);
    }
    for (const BoxId& id : all_boxes(state.document())) {
        const Extent extent = extent_of(state, id, *find_box(state.document(), id));
        const bool whole = box.low.x <= extent.low.x && box.low.y <= extent.low.y &&
                           box.high.x >= extent.high.x && box.high.y >= extent.high.y;
        if (whole && io.KeyCtrl)
            state.view.boxes.erase(id);
        else if (whole)
            state.view.boxes.insert(id);
    }
}

void drag_lasso(State& state) {
    if (!follow_stroke(state)) return;
    const Gesture& g = state.gesture;
    state.view.selected = g.selected;
    for (const Card& card : state.layout.cards)
        if (encloses(g.stroke, card.at + card.size * 0.5F)) state.view.selected.insert(card.id);
}

}  // namespace wrinkle::editor
