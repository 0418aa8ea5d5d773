// Dropped graphs: one in the folder of the open graph can be opened or become a node, others open.
#include <utility>

#include "editor/view/canvas/layout.h"
#include "editor/view/drop/drop.h"
#include "editor/view/edit/edits.h"
#include "editor/view/panels/prompt.h"

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
    const std::string file = path_in_graph(state, state.dropped.graph.files.front());
    draw_prompt(
        state, "##graph",
        {"Use " + file + " as a node?",
         "Or open it, which closes the graph in this window.",
         {{"Use as a node", "graph:node",
           [](State& s) { use_dropped(s, std::exchange(s.dropped.graph, {})); }},
          {"Open", "graph:open",
           [](State& s) { open_dropped(s, std::exchange(s.dropped.graph, {}).files.front()); }},
          {"Cancel", "graph:cancel", [](State& s) { s.dropped.graph = {}; }}}});
}

}  // namespace wrinkle::editor
