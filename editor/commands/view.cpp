#include "editor/canvas/layout.h"
#include "editor/commands/groups.h"
#include "editor/document/edits.h"

namespace wrinkle::editor {
namespace {

void show_commands(State& state) {
    const View& view = state.view;
    open_palette(state, {view.corner.x + view.extent.x / 2 - 144, view.corner.y + 64}, {});
    state.palette.commands = true;
}

template <int Step>
void zoom(State& state) {
    const View& view = state.view;
    zoom_at(state.view, {view.corner.x + view.extent.x / 2, view.corner.y + view.extent.y / 2},
            Step > 0 ? 1.21F : 1 / 1.21F);
}

constexpr Command table[] = {
    {"commands", "Search commands", "Ctrl+P", "View", always, show_commands},
    {"fit", "Show all", "Home", "View", always, [](State& s) { fit(s.view, s.layout, false); }},
    {"fit-selection", "Show selection", "F", "View", wants_selection,
     [](State& s) { fit(s.view, s.layout, true); }},
    {"zoom-in", "Zoom in", "Ctrl+Up", "View", always, zoom<1>},
    {"zoom-out", "Zoom out", "Ctrl+Down", "View", always, zoom<-1>},
};

}  // namespace

std::span<const Command> view_commands() {
    return table;
}

}  // namespace wrinkle::editor
