#include "editor/model/document/request.h"
#include "editor/view/commands/groups.h"
#include "editor/view/panels/browser.h"
#include "editor/view/preview/image_export.h"

namespace wrinkle::editor {
namespace {

template <gpu::View Which>
void show(State& state) {
    state.view.preview_view.view = Which;
    state.view.flat.on = false;
}
template <gpu::View Which>
bool shown(const State& state) {
    return !state.view.flat.on && state.view.preview_view.view == Which;
}

std::string_view one_node(const State& state) {
    if (!state.view.preview_request.node.empty()) return {};
    return state.view.selected.size() == 1 ? "" : "Select one node to preview it.";
}

// Previews the selected node instead of the outputs; if it is already previewed, or not exactly one
// node is selected, the outputs again.
void preview_node(State& state) {
    std::string& node = state.view.preview_request.node;
    const std::string selected =
        state.view.selected.size() == 1 ? *state.view.selected.begin() : "";
    if (selected.empty() || selected == node) {
        node.clear();
        state.status = "Previewing the outputs";
        return;
    }
    if (!shown_port(state.type_of(selected))) {
        state.status = selected + " makes nothing that can be shown on a surface.";
        return;
    }
    node = selected;
    state.status = "Previewing " + selected;
}

void show_flat(State& state) {
    state.view.flat.on = !state.view.flat.on;
}

void frame(State& state) {
    if (state.view.flat.on) {
        const FlatView usual;
        FlatView& flat = state.view.flat;
        flat.u = usual.u, flat.v = usual.v, flat.span = usual.span;
        return;
    }
    PreviewView& view = state.view.preview_view;
    const PreviewView usual;
    view.yaw = usual.yaw, view.pitch = usual.pitch, view.distance = usual.distance;
    view.pan_x = usual.pan_x, view.pan_y = usual.pan_y;
}

void turntable(State& state) {
    state.play.turning = !state.play.turning;
}

std::string_view no_time(const State& state) {
    return has_time(state) ? "" : "The graph has no input named time that its outputs read.";
}
void play_time(State& state) {
    state.play.running = !state.play.running;
}

void displaced(State& state) {
    state.view.preview_view.displaced = !state.view.preview_view.displaced;
}

template <CompareView::Mode Mode>
void compare(State& state) {
    CompareView& view = state.view.compare;
    view.mode = view.mode == Mode ? CompareView::Mode::off : Mode;
    view.flipped = false;
}
template <CompareView::Mode Mode>
bool compares(const State& state) {
    return state.view.compare.mode == Mode;
}

void flip(State& state) {
    CompareView& view = state.view.compare;
    view.flipped = view.mode == CompareView::Mode::flip ? !view.flipped : true;
    view.mode = CompareView::Mode::flip;
}

void difference(State& state) {
    CompareView& view = state.view.compare;
    view.difference = !view.difference;
    if (view.mode == CompareView::Mode::off) view.mode = CompareView::Mode::split;
}

template <bool Large>
void save_picture(State& state) {
    browse(state, Browser::Purpose::export_image, usual_image_path(state));
    state.browser.size = Large ? 2 : 0;
}

constexpr Command preview_table[] = {
    {"preview-node", "Preview node", "P", one_node, preview_node,
     [](const State& s) { return !s.view.preview_request.node.empty(); }},
    {"shaded", "Shaded", "1", always, show<gpu::View::shaded>, shown<gpu::View::shaded>},
    {"normal", "Normal", "2", always, show<gpu::View::normal>, shown<gpu::View::normal>},
    {"gradient", "Gradient", "3", always, show<gpu::View::gradient>, shown<gpu::View::gradient>},
    {"height", "Height", "4", always, show<gpu::View::height>, shown<gpu::View::height>},
    {"uv", "UV", "5", always, show<gpu::View::uv>, shown<gpu::View::uv>},
    {"wireframe", "Wireframe", "6", always, show<gpu::View::wireframe>,
     shown<gpu::View::wireframe>},
    {"flat", "2D: values of a node", "7", always, show_flat,
     [](const State& s) { return s.view.flat.on; }},
    {"bump-angle", "Angle of the bump", "", always, show<gpu::View::difference>,
     shown<gpu::View::difference>},
    {"save-picture", "Save image...", "", why_no_image, save_picture<false>},
    {"export-picture", "Export image in a size...", "", why_no_image, save_picture<true>},
    {"displaced", "Displaced", "", always, displaced,
     [](const State& s) { return s.view.preview_view.displaced; }},
    {"turntable", "Turntable", "Shift+T", always, turntable,
     [](const State& s) { return s.play.turning; }},
    {"play", "Play the input time", "K", no_time, play_time,
     [](const State& s) { return s.play.running; }},
    {"frame-preview", "Show all of the object", "Shift+F", always, frame},
    {"compare-split", "Compare side by side", "S", always, compare<CompareView::Mode::split>,
     compares<CompareView::Mode::split>},
    {"compare-flip", "Compare: turn to the other side", "X", always, flip,
     compares<CompareView::Mode::flip>},
    {"compare-difference", "Compare: degrees or image", "Shift+X", always, difference,
     [](const State& s) { return s.view.compare.difference; }},
};

}  // namespace

const std::span<const Command> preview_commands = preview_table;

}  // namespace wrinkle::editor
