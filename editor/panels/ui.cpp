#include "editor/panels/ui.h"
#include "editor/document/files.h"
#include "editor/document/refresh.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/canvas.h"
#include "editor/commands/commands.h"
#include "editor/drop/drop.h"
#include "editor/look/theme.h"
#include "editor/panels/offer_panel.h"
#include "editor/panels/palette.h"
#include "editor/panels/panels.h"
#include "editor/panels/popups.h"
#include "editor/panels/questions.h"

namespace wrinkle::editor {
namespace {

constexpr float menu_height = 28, tool_height = 40, status_height = 24;

// A part of the window at a fixed place.
class Region {
public:
    Region(const char* name, ImVec2 at, ImVec2 size, ImU32 color, ImVec2 padding = {0, 0}) {
        ImGui::SetNextWindowPos(at);
        ImGui::SetNextWindowSize(size);
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

// A splitter grabs 8 px round its line.
void draw_splitter(const char* id, ImVec2 at, ImVec2 size, bool vertical, float& fraction,
                   float whole) {
    const Region region(id, at, size, theme::border);
    ImGui::InvisibleButton(id, size);
    if (!ImGui::IsItemActive()) return;
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    fraction = std::clamp(fraction + (vertical ? -delta.x : delta.y) / whole, 0.15F, 0.7F);
}

void draw_bars(State& state, ImVec2 size) {
    {
        const Region region("##menu", {0, 0}, {size.x, menu_height}, theme::bar);
        draw_menu_bar(state);
    }
    {
        const Region region("##tools", {0, menu_height}, {size.x, tool_height}, theme::bar, {8, 6});
        draw_toolbar(state);
    }
    const Region region("##status", {0, size.y - status_height}, {size.x, status_height},
                        theme::bar, {12, 4});
    draw_status_bar(state);
}

void draw_left(State& state, float top, float width, float height) {
    const float problems = std::min(problems_height(state), height * 0.25F);
    {
        const Region region("##canvas", {0, top}, {width, height - problems}, theme::canvas);
        draw_canvas(state);
    }
    const Region region("##problems", {0, top + height - problems}, {width, problems}, theme::panel,
                        {12, 5});
    draw_problems(state);
}

void draw_side(State& state, ImVec2 at, ImVec2 size) {
    const float preview = std::round(size.y * state.view.preview);
    {
        const Region region("##preview", at, {size.x, preview}, theme::panel);
        draw_preview(state);
    }
    draw_splitter("##split-preview", {at.x, at.y + preview}, {size.x, 3}, false, state.view.preview,
                  size.y);
    const Region region("##code", {at.x, at.y + preview + 3}, {size.x, size.y - preview - 3},
                        theme::code);
    draw_code(state);
}

}  // namespace

void draw_ui(State& state) {
    state.targets.clear();
    run_keys(state);
    refresh(state);
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float work = size.y - menu_height - tool_height - status_height;
    const float top = menu_height + tool_height;
    const float side =
        std::clamp(std::round(size.x * state.view.side / 8) * 8, 320.0F, size.x * 0.7F);
    const float left = size.x - side - 3;
    draw_bars(state, size);
    draw_left(state, top, left, work);
    draw_splitter("##split-side", {left, top}, {3, work}, true, state.view.side, size.x);
    draw_side(state, {left + 3, top}, {side, work});
    draw_palette(state);
    draw_offer(state);
    draw_popup(state);
    draw_copy_question(state);
    draw_question(state);
    handle_drops(state);
    tend(state);
}

}  // namespace wrinkle::editor
