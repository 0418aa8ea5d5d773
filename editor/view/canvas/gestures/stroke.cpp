// Strokes across wires: cut them, or insert a reroute in each.
#include <algorithm>
#include <cmath>
#include <map>

#include "editor/model/document/wiring.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr size_t max_points = 4096;

// Inserts one reroute into wires of the same source; it feeds all their readers.
Document with_reroute(const Document& document, const std::vector<Connection>& wires, ImVec2 at) {
    Node node = new_node(document, reroute_type, reroute_type);
    const std::string id = node.id;
    const ImVec2 corner = at - ImVec2(reroute_width, reroute_height) * 0.5F;
    Document result =
        add_node(document, std::move(node), std::round(corner.x / 8) * 8, std::round(corner.y));
    result = connect(result, wires.front().from, id, "in");
    for (const Connection& wire : wires)
        result = with_wire(result, {id, "out"}, wire.node, wire.port);
    return result;
}

}  // namespace

bool follow_stroke(CanvasState& canvas) {
    Gesture& g = canvas.gesture;
    const ImVec2 at = to_canvas(canvas.view, ImGui::GetIO().MousePos);
    if (g.stroke.empty()) g.stroke.push_back(to_canvas(canvas.view, g.start));
    const ImVec2 last = g.stroke.back();
    if ((last.x == at.x && last.y == at.y) || g.stroke.size() == max_points) return false;
    g.stroke.push_back(at);
    return true;
}

void drag_stroke(State& state, ImVec2) {
    if (!follow_stroke(state)) return;
    Gesture& g = state.gesture;
    const ImVec2 last = g.stroke[g.stroke.size() - 2], at = g.stroke.back();
    for (size_t i = 0; i < state.layout.wires.size(); ++i) {
        const auto place = crossing(state.layout, i, last, at);
        if (!place) continue;
        const bool known =
            std::ranges::any_of(g.crossed, [&](const auto& each) { return each.wire == i; });
        if (!known) g.crossed.push_back({i, *place});
    }
}

void drop_cut(State& state) {
    std::vector<Connection> wires;
    for (const Gesture::Crossing& each : state.gesture.crossed)
        wires.push_back(state.layout.wires[each.wire]);
    const std::string what = wires.size() == 1 ? "1 wire" : std::to_string(wires.size()) + " wires";
    state.commit("Cut " + what, cut_wires(state.model, state.document(), wires));
}

void drop_reroutes(State& state) {
    std::map<std::string, std::vector<Gesture::Crossing>> by_source;
    for (const Gesture::Crossing& each : state.gesture.crossed)
        by_source[state.layout.wires[each.wire].from.text()].push_back(each);
    Document document = state.document();
    for (const auto& [source, crossings] : by_source) {
        std::vector<Connection> wires;
        ImVec2 middle(0, 0);
        for (const Gesture::Crossing& each : crossings) {
            wires.push_back(state.layout.wires[each.wire]);
            middle = middle + each.at * (1 / static_cast<float>(crossings.size()));
        }
        document = with_reroute(document, wires, middle);
    }
    state.commit("Reroute", std::move(document));
}

void reroute_wire(State& state, size_t wire, ImVec2 at) {
    state.commit("Reroute", with_reroute(state.document(), {state.layout.wires[wire]}, at));
}

}  // namespace wrinkle::editor
