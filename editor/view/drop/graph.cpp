// Dropped graphs: one in the folder of the open graph can be opened or become a node, others open.
#include "editor/view/canvas/layout.h"
#include "editor/view/drop/drop.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

void open_dropped(State& state, const std::string& file) {
    request_action(state, {PendingAction::Kind::open, file});
}

void use_dropped(State& state, const FileDrop& drop) {
    const std::string file = path_in_graph(state, drop.files.front());
    const std::optional<NodeType> type = subgraph_type(state.model, file, state.status);
    if (type) add_node_of_type(state, *type, to_canvas(state.view, {drop.x, drop.y}), {});
}

enum class GraphAnswer : uint8_t { asking, node, open, cancel };

GraphAnswer draw_graph_answers(Interface& interface) {
    GraphAnswer answer = GraphAnswer::asking;
    ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_fill);
    if (button(interface, "Use as a node", "graph:node")) answer = GraphAnswer::node;
    ImGui::PopStyleColor();
    ImGui::SameLine();
    if (button(interface, "Open", "graph:open")) answer = GraphAnswer::open;
    ImGui::SameLine();
    if (button(interface, "Cancel", "graph:cancel")) answer = GraphAnswer::cancel;
    if (is_pressed(ImGuiKey_Escape)) return GraphAnswer::cancel;
    return is_pressed(ImGuiKey_Enter) ? GraphAnswer::node : answer;
}

}  // namespace

void take_graph(State& state, const FileDrop& drop) {
    std::error_code ignored;
    const fs::path file = drop.files.front();
    if (state.document().nodes.empty() || path_in_graph(state, file).empty() ||
        fs::equivalent(file, state.path, ignored))
        return open_dropped(state, file);
    state.dropped.graph = drop;
}

void draw_graph_question(State& state) {
    if (state.dropped.graph.files.empty()) return;
    const Dialog dialog("##graph", {420, 0}, {24, 24}, 8, 0.4F);
    if (!dialog) return;
    const FileDrop drop = state.dropped.graph;
    write_paragraph(
        theme::text,
        "Use " + path_in_graph(state, drop.files.front()) + " as a node of this graph, or open it?",
        372);
    ImGui::Dummy({0, 8});
    const GraphAnswer answer = draw_graph_answers(state);
    if (answer == GraphAnswer::asking) return;
    state.dropped.graph = {};
    ImGui::CloseCurrentPopup();
    if (answer == GraphAnswer::node) use_dropped(state, drop);
    if (answer == GraphAnswer::open) open_dropped(state, drop.files.front());
}

}  // namespace wrinkle::editor
