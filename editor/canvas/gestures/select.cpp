#include "editor/canvas/gestures/gestures.h"

#include <algorithm>

#include "editor/canvas/layout.h"

namespace wrinkle::editor {

void select_card(State& state, const std::string& id) {
    std::set<std::string>& selected = state.view.selected;
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyShift || io.KeyCtrl) {
        if (!selected.erase(id)) selected.insert(id);
    } else if (!selected.contains(id)) {
        selected = {id};
    }
    std::erase(state.view.order, id);
    state.view.order.push_back(id);
    state.layout_stale = true;
}

void click_card(State& state, const std::string& id) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.KeyShift && !io.KeyCtrl) state.view.selected = {id};
}

void drag_box(State& state) {
    const ImVec2 a = to_canvas(state.view, state.gesture.start);
    const ImVec2 b = to_canvas(state.view, ImGui::GetIO().MousePos);
    const ImVec2 low(std::min(a.x, b.x), std::min(a.y, b.y));
    const ImVec2 high(std::max(a.x, b.x), std::max(a.y, b.y));
    if (!ImGui::GetIO().KeyShift) state.view.selected.clear();
    for (const Card& card : state.layout.cards)
        if (card.at.x < high.x && card.at.y < high.y && card.at.x + card.size.x > low.x &&
            card.at.y + card.size.y > low.y)
            state.view.selected.insert(card.id);
}

}  // namespace wrinkle::editor
