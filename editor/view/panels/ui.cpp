#include "editor/view/panels/ui.h"
#include "editor/view/lifecycle.h"
#include "editor/view/refresh.h"

#include "editor/view/canvas/canvas.h"
#include "editor/view/commands/commands.h"
#include "editor/view/drop/drop.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/bake_dialog.h"
#include "editor/view/panels/box_text.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/fields.h"
#include "editor/view/panels/help.h"
#include "editor/view/panels/offer_panel.h"
#include "editor/view/panels/palette.h"
#include "editor/view/panels/panels.h"
#include "editor/view/panels/popups.h"
#include "editor/view/panels/questions.h"
#include "editor/view/panels/regions.h"
#include "editor/view/panels/start_page.h"

namespace wrinkle::editor {
namespace {

// ImGui window at a fixed position, ended by the destructor.
class Region {
public:
    Region(const char* name, const Rect& rect, ImU32 color, ImVec2 padding = {0, 0}) {
        ImGui::SetNextWindowPos(rect.at);
        ImGui::SetNextWindowSize(rect.size);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
        ImGui::PushStyleColor(ImGuiCol_WindowBg, color);
        ImGui::Begin(name, nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                         ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoNavInputs);
    }
    Region(const Region&) = delete;
    Region& operator=(const Region&) = delete;
    ~Region() {
        ImGui::End();
        ImGui::PopStyleColor();
        ImGui::PopStyleVar(2);
    }
};

void draw_bars(State& state, const Regions& regions) {
    {
        const Region region("##menu", regions.menu, theme::bar);
        draw_menu_bar(state);
    }
    {
        const Region region("##tools", regions.tools, theme::bar, {8, 6});
        draw_toolbar(state);
        const ImVec2 end = regions.tools.at + regions.tools.size;
        ImGui::GetWindowDrawList()->AddLine({0, end.y - 1}, {end.x, end.y - 1}, theme::border);
    }
    if (regions.task.size.y > 0) {
        const Region region("##task", regions.task, theme::bar, {12, 6});
        draw_task(state);
    }
    const Region region("##status", regions.status, theme::bar, {12, 4});
    ImGui::GetWindowDrawList()->AddLine(
        regions.status.at, regions.status.at + ImVec2(regions.status.size.x, 0), theme::border);
    draw_status_bar(state, regions);
}

void draw_panes(State& state, const Regions& regions) {
    if (regions.canvas.size.x > 0) {
        {
            const Region region("##canvas", regions.canvas, theme::canvas);
            is_at_start(state) ? draw_start_page(state) : draw_canvas(state);
        }
        if (!is_at_start(state)) draw_overlays(state);
    }
    if (regions.problems.size.x > 0) {
        const Region region("##problems", regions.problems, theme::panel, {12, 5});
        draw_problems(state);
    }
    if (regions.preview.size.x > 0) {
        const Region region("##preview", regions.preview, theme::panel);
        draw_preview(state);
    }
    if (regions.code.size.x > 0) {
        const Region region("##code", regions.code, theme::code);
        draw_code(state);
    }
}

}  // namespace

void draw_ui(State& state) {
    state.targets.clear();
    state.thumbnails.begin_frame();
    age_field_wait(state);
    run_keys(state);
    poll_tasks(state);
    refresh(state);
    poll_images(state);
    const Regions regions = regions_of(state);
    draw_bars(state, regions);
    draw_panes(state, regions);
    draw_splitters(state.panes, regions);
    draw_palette(state);
    draw_offer(state);
    draw_box_text(state);
    draw_popup(state);
    draw_bake_dialog(state);
    draw_browser(state);
    draw_help(state);
    draw_hover_docs(state);
    draw_copy_question(state);
    draw_question(state);
    handle_drops(state);
    tend(state);
}

}  // namespace wrinkle::editor
