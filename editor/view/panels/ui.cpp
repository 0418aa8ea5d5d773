#include <utility>

#include "editor/model/hosts/repeated_exports.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/commands/commands.h"
#include "editor/view/drop/drop.h"
#include "editor/view/lifecycle.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/regions.h"
#include "editor/view/refresh.h"

namespace wrinkle::editor {

// To add a panel: its file, which defines `void draw_NAME(State&)`, and its declaration and row
// here.
void draw_menu_bar(State& state);
void draw_toolbar(State& state);
void draw_task(State& state);
void draw_status_bar(State& state);
void draw_problems(State& state);
void draw_preview(State& state);
void draw_code(State& state);
void draw_start_page(State& state);
void draw_overlays(State& state);
void draw_splitters(State& state);
void draw_palette(State& state);
void draw_offer(State& state);
void draw_box_text(State& state);
void draw_popup(State& state);
void draw_context_menu(State& state);
void draw_bake_dialog(State& state);
void draw_host_dialog(State& state);
void draw_browser(State& state);
void draw_help(State& state);
void draw_hover_docs(State& state);
void draw_copy_question(State& state);
void draw_graph_question(State& state);
void draw_question(State& state);

namespace {

void draw_graph_pane(State& state) {
    is_at_start(state) ? draw_start_page(state) : draw_canvas(state);
}

void draw_side_pane(State& state) {
    state.inputs_panel.shown ? draw_inputs(state) : draw_code(state);
}

// Fills a rectangle of the window.
struct DockedPanel {
    const char* window;
    Rect Regions::*rect;
    const ImU32* background;  // nullptr: theme::canvas, with which the window is cleared
    ImVec2 padding;
    void (*draw)(State&);
};
const DockedPanel docked_panels[] = {
    {"##menu", &Regions::menu, &theme::bar, {0, 0}, draw_menu_bar},
    {"##tools", &Regions::tools, &theme::bar, {8, 6}, draw_toolbar},
    {"##task", &Regions::task, &theme::bar, {12, 6}, draw_task},
    {"##status", &Regions::status, &theme::bar, {12, 4}, draw_status_bar},
    {"##canvas", &Regions::canvas, nullptr, {0, 0}, draw_graph_pane},
    {"##problems", &Regions::problems, &theme::panel, {12, 5}, draw_problems},
    {"##preview", &Regions::preview, &theme::panel, {0, 0}, draw_preview},
    {"##code", &Regions::code, &theme::code, {0, 0}, draw_side_pane},
};
constexpr ImGuiWindowFlags docked_flags =
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse |
    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoNavInputs;

// Open their own windows and popups above the others while they are shown, in this order.
constexpr void (*floating_panels[])(State&) = {
    draw_overlays, draw_splitters,    draw_palette,       draw_offer,          draw_box_text,
    draw_popup,    draw_context_menu, draw_bake_dialog,   draw_host_dialog,    draw_browser,
    draw_help,     draw_hover_docs,   draw_copy_question, draw_graph_question, draw_question,
};

void draw_panels(State& state) {
    const Regions regions = regions_of(state);
    for (const DockedPanel& panel : docked_panels) {
        const Rect& rect = regions.*panel.rect;
        if (rect.size.x <= 0 || rect.size.y <= 0) continue;
        const ImU32 background = panel.background ? *panel.background : 0;
        const FixedWindow window(
            panel.window, rect.at, rect.size,
            {.padding = panel.padding, .ground = background, .flags = docked_flags});
        panel.draw(state);
    }
    for (const auto draw : floating_panels)
        draw(state);
    state.value_held = std::exchange(state.holds_value, false);
    state.eyedropper.on = std::exchange(state.eyedropper.drawn, false);
    if (!state.eyedropper.on) state.eyedropper.pixel.reset();
}

}  // namespace

void draw_ui(State& state) {
    state.targets.clear();
    state.flat.panel = {};
    state.thumbnails.begin_frame();
    age_field_wait(state);
    poll_tasks(state);
    poll_repeated_exports(state);
    refresh(state);  // commands use the layout of the current document
    run_keys(state);
    refresh(state);
    advance(state, static_cast<double>(ImGui::GetIO().DeltaTime));
    poll_images(state);
    draw_panels(state);
    handle_drops(state);
    autosave_and_check_files(state);
}

}  // namespace wrinkle::editor
