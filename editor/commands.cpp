#include "editor/commands.h"

#include "base/text.h"
#include "editor/edits.h"
#include "editor/input_queue.h"
#include "editor/layout.h"

namespace wrinkle::editor {
namespace {

bool always(const State&) {
    return true;
}
bool has_selection(const State& state) {
    return !state.view.selected.empty();
}
bool can_delete(const State& state) {
    return has_selection(state) || state.view.selected_wire;
}

void undo(State& state) {
    const std::string name = state.history.undo_name();
    state.history.undo();
    state.status = "Undid: " + name;
}

void redo(State& state) {
    const std::string name = state.history.redo_name();
    state.history.redo();
    state.status = "Redid: " + name;
}

void quit(State& state) {
    (state.dirty() ? state.quit_asked : state.quit) = true;
}

void select_all(State& state) {
    for (const NodePtr& node : state.document().nodes)
        state.view.selected.insert(node->id);
}

void add_node(State& state) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const View& view = state.view;
    const ImVec2 end(view.corner.x + view.extent.x, view.corner.y + view.extent.y);
    const bool over =
        mouse.x >= view.corner.x && mouse.y >= view.corner.y && mouse.x < end.x && mouse.y < end.y;
    open_palette(state,
                 over ? mouse
                      : to_screen(view, to_canvas(view, {(view.corner.x + end.x) / 2,
                                                         (view.corner.y + end.y) / 2})),
                 {});
}

void show_commands(State& state) {
    const View& view = state.view;
    open_palette(state, {view.corner.x + view.extent.x / 2 - 144, view.corner.y + 64}, {});
    state.palette.commands = true;
}

void reload(State& state) {
    if (state.preview) state.preview->forget_images();
    state.fresh = false;
    state.status = "Read the images and sub-graphs again";
}

void tidy(State& state) {
    state.view.surface_at.reset();
    state.view.outputs_at.reset();
    state.commit("Tidy", tidied(state));
    state.view.fitted = false;
}

template <int Step>
void zoom(State& state) {
    const View& view = state.view;
    zoom_at(state.view, {view.corner.x + view.extent.x / 2, view.corner.y + view.extent.y / 2},
            Step > 0 ? 1.21F : 1 / 1.21F);
}

template <gpu::View Which>
void show(State& state) {
    state.view.preview_view.view = Which;
}

constexpr Command table[] = {
    {"save", "Save", "Ctrl+S", "File", always, [](State& s) { save_file(s); }},
    {"reload", "Read images again", "F5", "File", always, reload},
    {"quit", "Quit", "Ctrl+Q", "File", always, quit},
    {"undo", "Undo", "Ctrl+Z", "Edit", [](const State& s) { return s.history.can_undo(); }, undo},
    {"redo", "Redo", "Ctrl+Shift+Z", "Edit", [](const State& s) { return s.history.can_redo(); },
     redo},
    {"delete", "Delete", "Delete", "Edit", can_delete, delete_selected},
    {"duplicate", "Duplicate", "Ctrl+D", "Edit", has_selection, duplicate_selected},
    {"select-all", "Select all", "Ctrl+A", "Edit", always, select_all},
    {"add-node", "Add node", "Space", "Node", always, add_node},
    {"mute", "Mute", "M", "Node", has_selection, mute_selected},
    {"tidy", "Tidy", "Ctrl+L", "Node", always, tidy},
    {"commands", "Search commands", "Ctrl+P", "View", always, show_commands},
    {"fit", "Show all", "Home", "View", always, [](State& s) { fit(s.view, s.layout, false); }},
    {"fit-selection", "Show selection", "F", "View", has_selection,
     [](State& s) { fit(s.view, s.layout, true); }},
    {"zoom-in", "Zoom in", "Ctrl+Up", "View", always, zoom<1>},
    {"zoom-out", "Zoom out", "Ctrl+Down", "View", always, zoom<-1>},
    {"shaded", "Shaded", "1", "Preview", always, show<gpu::View::shaded>},
    {"normal", "Normal", "2", "Preview", always, show<gpu::View::normal>},
    {"gradient", "Gradient", "3", "Preview", always, show<gpu::View::gradient>},
    {"height", "Height", "4", "Preview", always, show<gpu::View::height>},
    {"uv", "UV", "5", "Preview", always, show<gpu::View::uv>},
    {"difference", "Difference", "6", "Preview", always, show<gpu::View::difference>},
};

bool pressed(std::string_view keys) {
    const ImGuiIO& io = ImGui::GetIO();
    bool ctrl = false, shift = false, alt = false;
    int key = 0;
    for (const std::string_view part : split(keys, '+')) {
        ctrl |= part == "Ctrl";
        shift |= part == "Shift";
        alt |= part == "Alt";
        key = key_named(part);
    }
    return key != 0 && io.KeyCtrl == ctrl && io.KeyShift == shift && io.KeyAlt == alt &&
           ImGui::IsKeyPressed(key, false);
}

}  // namespace

std::span<const Command> commands() {
    return table;
}

const Command* find_command(std::string_view id) {
    for (const Command& command : table)
        if (command.id == id) return &command;
    return nullptr;
}

bool run_command(State& state, std::string_view id) {
    const Command* command = find_command(id);
    if (!command || !command->enabled(state)) return false;
    command->run(state);
    return true;
}

void run_keys(State& state) {
    if (ImGui::GetIO().WantTextInput || state.palette.open ||
        state.popup.kind != Popup::Kind::none || state.gesture.kind != Gesture::Kind::none)
        return;
    for (const Command& command : table)
        if (!command.keys.empty() && pressed(command.keys) && command.enabled(state))
            return command.run(state);
}

}  // namespace wrinkle::editor
