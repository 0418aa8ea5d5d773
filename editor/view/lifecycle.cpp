#include "editor/view/lifecycle.h"

#include <algorithm>

#include "editor/model/document/files.h"
#include "editor/model/document/levels.h"
#include "editor/model/document/recovery.h"
#include "editor/view/preview/feed.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace {

void show_graph(State& state, GraphSwitch how) {
    View former = std::exchange(state.view, {});
    if (how == GraphSwitch::entered) {
        state.view.preview_view = former.preview_view;
        state.parent_views.push_back(std::move(former));
    } else if (how == GraphSwitch::left) {
        state.view = std::move(state.parent_views[state.parent_graphs.size()]);
    }
    state.parent_views.resize(state.parent_graphs.size());
    state.gesture = {};
    state.palette = {};
    state.popup = {};
    state.offer = {};
    state.box_text = {};
    state.dropped.waiting.clear();
    if (state.preview) state.preview->forget_material();
    state.play = {.turning = state.play.turning};
    state.node_feed.forget();
    state.flat.forget();
    state.preview_problems = Diagnostics();
}

WindowFiles window_files(const State& state) {
    const PreviewView& view = state.view.preview_view;
    WindowFiles files{is_shape(view.mesh) ? "" : view.mesh, view.environment, {}};
    for (const DropEvent& each : state.dropped.waiting)
        files.dropped.insert(files.dropped.end(), each.files.begin(), each.files.end());
    return files;
}

bool follow_all_files(State& state) {
    const std::vector<UsedFile> changed = follow_files(state, window_files(state));
    for (const UsedFile& file : changed) {
        if (file.use == Use::plugin) state.offer = {};
        if (file.use == Use::image) state.thumbnails.forget(file.path);
        forget_files(state, file.use);
    }
    return !changed.empty();
}

void keep_settings(State& state) {
    Persistence& keeping = state.keeping;
    keeping.settings.side = state.panes.side;
    keeping.settings.preview = state.panes.preview;
    keeping.settings.problems = state.panes.problems;
    keeping.settings.theme = state.look.theme == Theme::light ? "light" : "dark";
    keeping.settings.scale = state.look.scale;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    if (size.x >= 1 && size.y >= 1) {
        keeping.settings.width = static_cast<int>(size.x * state.look.scale);
        keeping.settings.height = static_cast<int>(size.y * state.look.scale);
    }
    if (keeping.settings == keeping.written || ImGui::IsAnyMouseDown()) return;
    const std::string why = write_settings(keeping.folders, keeping.settings);
    if (!why.empty() && why != keeping.unsettled)
        state.status = "The settings were not saved: " + why + ".";
    keeping.unsettled = why;
    keeping.written = keeping.settings;
}

}  // namespace

State::State() {
    on_switch = [this](GraphSwitch how) { show_graph(*this, how); };
}

bool autosave_and_check_files(State& state) {
    keep_edits(state, ImGui::IsAnyMouseDown());
    const bool read = follow_all_files(state);
    const double now = seconds_now();
    if (now - state.keeping.checked_at < 1) return read;
    state.keeping.checked_at = now;
    state.keeping.try_again = true;
    state.recovery_file.sync();
    for (OpenGraph& parent : state.parent_graphs)
        parent.recovery_file.sync();
    keep_settings(state);
    const bool busy = state.gesture.kind != Gesture::Kind::none || state.question.open() ||
                      state.popup.kind != Popup::Kind::none;
    const std::string status = state.status;
    if (!busy && !state.path.empty()) check_disk_changes(state);
    return read || state.question.open() || state.status != status;
}

void use_settings(State& state, const Settings& settings) {
    state.keeping.settings = state.keeping.written = settings;
    state.panes.side = settings.side;
    state.panes.preview = settings.preview;
    state.panes.problems = settings.problems;
    state.look.theme = settings.theme == "light" ? Theme::light : Theme::dark;
    for (const float scale : interface_scales)
        if (scale <= settings.scale) state.look.scale = scale;
}

void finish(State& state) {
    state.recovery_file.remove();
    close_outer(state);
    keep_settings(state);
}

}  // namespace wrinkle::editor
