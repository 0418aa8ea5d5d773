#include "editor/canvas/layout.h"
#include "editor/commands/groups.h"
#include "editor/document/edits.h"

namespace wrinkle::editor {
namespace {

void add_node(State& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const View& view = state.view;
    const ImVec2 end(view.corner.x + view.extent.x, view.corner.y + view.extent.y);
    const ImVec2 middle((view.corner.x + end.x) / 2, (view.corner.y + end.y) / 2);
    const bool over =
        mouse.x >= view.corner.x && mouse.y >= view.corner.y && mouse.x < end.x && mouse.y < end.y;
    open_palette(state, over ? mouse : middle, {});
}

void tidy(State& state) {
    state.view.surface_at.reset();
    state.view.outputs_at.reset();
    state.commit("Tidy", tidied(state));
    state.view.fitted = false;
}

constexpr Command table[] = {
    {"add-node", "Add node", "Space", "Node", always, add_node},
    {"mute", "Mute", "M", "Node", wants_selection, mute_selected},
    {"tidy", "Tidy", "Ctrl+L", "Node", always, tidy},
};

}  // namespace

std::span<const Command> node_commands() {
    return table;
}

}  // namespace wrinkle::editor
