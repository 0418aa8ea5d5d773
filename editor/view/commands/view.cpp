#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/groups.h"
#include "editor/view/edit/edits.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/regions.h"

namespace wrinkle::editor {
namespace {

template <int Step>
void zoom(State& state) {
    const View& view = state.view;
    zoom_at(state.view, state.layout,
            {view.corner.x + view.extent.x / 2, view.corner.y + view.extent.y / 2},
            Step > 0 ? 1.21F : 1 / 1.21F);
}

template <Theme Which>
void use_theme(State& state) {
    state.look.theme = Which;
}
template <Theme Which>
bool is_used(const State& state) {
    return state.look.theme == Which;
}

template <int By>
void rescale(State& state) {
    state.look.scale = next_scale(state.look.scale, By);
    state.status = "Interface at " + percent(state.look.scale);
}
template <int By>
std::string_view no_scale(const State& state) {
    if (next_scale(state.look.scale, By) != state.look.scale) return {};
    return By > 0 ? "It is as large as it gets." : "It is as small as it gets.";
}

bool shows_side(const State& state) {
    return state.panes.side_shown.value_or(regions_of(state).preview.size.x > 0);
}

void toggle_side(State& state) {
    state.panes.side_shown = !shows_side(state);
    state.panes.maximised = Pane::none;
}

bool shows_inputs(const State& state) {
    return state.inputs_panel.shown && shows_side(state);
}

// Shows the inputs instead of the code, and the side column if it is hidden.
void turn_inputs(State& state) {
    const bool shows = !shows_inputs(state);
    state.inputs_panel.shown = shows;
    if (shows && !shows_side(state)) toggle_side(state);
}

void maximise(State& state) {
    Pane& maximised = state.panes.maximised;
    maximised = maximised != Pane::none ? Pane::none : regions_of(state).at(ImGui::GetMousePos());
}
bool is_maximised(const State& state) {
    return state.panes.maximised != Pane::none;
}

constexpr Command view_table[] = {
    {"commands", "Search commands", "Ctrl+P", always,
     [](State& s) { open_list(s, Palette::List::commands); }},
    {"fit", "Show all", "Home", always, [](State& s) { show_nodes(s, false); }},
    {"fit-selection", "Show selection", "F", wants_selection,
     [](State& s) { show_nodes(s, true); }},
    {"next-problem", "Next problem", "F8", no_problems, next_problem},
    {"zoom-in", "Zoom in", "Ctrl+Up", always, zoom<1>},
    {"zoom-out", "Zoom out", "Ctrl+Down", always, zoom<-1>},
    {"trace", "Trace the selection", "T", always,
     [](State& s) { s.view.tracing = !s.view.tracing; },
     [](const State& s) { return s.view.tracing; }},
    {"heat", "Tint costs", "H", always, [](State& s) { s.view.heat = !s.view.heat; },
     [](const State& s) { return s.view.heat; }},
    {"pictures", "Thumbnails on nodes", "Shift+V", always,
     [](State& s) {
         s.view.node_previews = !s.view.node_previews;
         s.layout_stale = true;
     },
     [](const State& s) { return s.view.node_previews; }},
    {"side", "Preview and code", "F6", always, toggle_side, shows_side},
    {"inputs", "Inputs of the graph", "Shift+E", always, turn_inputs, shows_inputs},
    {"maximise", "Maximise the panel under the pointer", "F11", always, maximise, is_maximised},
    {"dark-theme", "Dark theme", "", always, use_theme<Theme::dark>, is_used<Theme::dark>},
    {"light-theme", "Light theme", "", always, use_theme<Theme::light>, is_used<Theme::light>},
    {"larger", "Larger interface", "Ctrl+Shift+Up", no_scale<1>, rescale<1>},
    {"smaller", "Smaller interface", "Ctrl+Shift+Down", no_scale<-1>, rescale<-1>},
};

}  // namespace

const std::span<const Command> view_commands = view_table;

}  // namespace wrinkle::editor
