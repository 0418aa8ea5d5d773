#include "editor/view/panels/regions.h"

#include <algorithm>
#include <cmath>

#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "editor/view/state.h"

namespace wrinkle::editor {
namespace {

constexpr float menu_height = 28, tool_height = 40, status_height = 24;
constexpr float problems_header = 28, preview_bars = 34 + 32 + 42;
constexpr float wide_window = 960, tall_window = 800;
constexpr float grab = 4;  // pixels on both sides of a splitter

float side_width(const Panes& panes, float window) {
    if (panes.side > 0)
        return std::clamp(std::round(window * panes.side / 8) * 8, 320.0F, window * 0.7F);
    return std::clamp(std::round(window * 0.3F / 8) * 8, 400.0F, 768.0F);
}

float preview_height(const Panes& panes, ImVec2 side) {
    if (panes.preview > 0) return std::round(side.y * std::clamp(panes.preview, 0.15F, 0.85F));
    const float wrapped = side.x < 520 ? 32.0F : 0.0F;
    const float wanted = preview_bars + wrapped + std::round(side.x * 13 / 18);
    return std::round(std::min(wanted, side.y * 0.56F));
}

float problems_height(const Panes& panes, float window, float work, float rows) {
    if (panes.problems > 0)
        return std::min(std::max(std::round(work * panes.problems), problems_header), work * 0.6F);
    if (window < tall_window) return std::min(problems_header, work);
    return std::max(problems_header, std::min(rows, std::round(work * 0.2F)));
}

void divide(Regions& regions, const Panes& panes, ImVec2 window, float rows) {
    const Rect& work = regions.work;
    const bool side = panes.side_shown.value_or(window.x >= wide_window);
    const float wide = side ? std::min(side_width(panes, window.x), work.size.x) : 0;
    const float left = work.size.x - wide;
    const float below = problems_height(panes, window.y, work.size.y, rows);
    regions.canvas = {work.at, {left, work.size.y - below}};
    regions.problems = {{work.at.x, work.at.y + work.size.y - below}, {left, below}};
    if (!side) return;
    const float upper = preview_height(panes, {wide, work.size.y});
    regions.preview = {{work.at.x + left, work.at.y}, {wide, upper}};
    regions.code = {{work.at.x + left, work.at.y + upper}, {wide, work.size.y - upper}};
}

struct Splitter {
    const char* id;
    Rect line;
    bool upright;
    float& fraction;
    float edge;  // fixed edge of the pane that is resized
    float whole;
};

void draw_splitter(const Splitter& splitter) {
    const ImVec2 reach = splitter.upright ? ImVec2(grab, 0) : ImVec2(0, grab);
    const ImVec2 size = splitter.line.size + reach * 2;
    const FixedWindow window(splitter.id, splitter.line.at - reach, size, {.flags = overlay_flags});
    press_area(splitter.id, size);
    const bool held = ImGui::IsItemActive(), bright = held || ImGui::IsItemHovered();
    if (bright)
        ImGui::SetMouseCursor(splitter.upright ? ImGuiMouseCursor_ResizeEW
                                               : ImGuiMouseCursor_ResizeNS);
    const float thick = bright ? 2.0F : 1.0F;
    const ImVec2 end = splitter.line.at + (splitter.upright ? ImVec2(thick, splitter.line.size.y)
                                                            : ImVec2(splitter.line.size.x, thick));
    ImGui::GetWindowDrawList()->AddRectFilled(splitter.line.at, end,
                                              bright ? theme::accent : theme::border);
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 way = io.MousePos - io.MouseClickedPos[0];
    const bool moved = std::max(std::fabs(way.x), std::fabs(way.y)) > 1;
    const bool dragged = moved && (held || ImGui::IsItemDeactivated());
    const float mouse = splitter.upright ? io.MousePos.x : io.MousePos.y;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
        splitter.fraction = 0;
    else if (dragged)
        splitter.fraction =
            std::clamp(std::fabs(splitter.edge - mouse) / splitter.whole, 0.02F, 0.98F);
}

}  // namespace

const Rect& Regions::of(Pane pane) const {
    static const Rect nowhere;
    const Rect* const of_pane[] = {&nowhere, &canvas, &problems, &preview, &code};
    return *of_pane[static_cast<size_t>(pane)];
}

Pane Regions::at(ImVec2 point) const {
    for (const Pane pane : {Pane::canvas, Pane::problems, Pane::preview, Pane::code})
        if (of(pane).contains(point)) return pane;
    return Pane::none;
}

Regions regions_of(const State& state) {
    return find_regions(state.panes, ImGui::GetIO().DisplaySize, problems_height(state),
                        state.tasks.shown() ? task_height : 0);
}

Regions find_regions(const Panes& panes, ImVec2 window, float problems, float task) {
    Regions regions;
    regions.menu = {{0, 0}, {window.x, menu_height}};
    regions.tools = {{0, menu_height}, {window.x, tool_height}};
    const float top = menu_height + tool_height;
    const float work = std::max(window.y - top - task - status_height, 1.0F);
    regions.work = {{0, top}, {window.x, work}};
    regions.task = {{0, top + work}, {window.x, task}};
    regions.status = {{0, top + work + task}, {window.x, status_height}};
    divide(regions, panes, window, problems);
    if (panes.maximised == Pane::none) return regions;
    const auto whole = [&](Pane pane) { return pane == panes.maximised ? regions.work : Rect{}; };
    regions.canvas = whole(Pane::canvas);
    regions.problems = whole(Pane::problems);
    regions.preview = whole(Pane::preview);
    regions.code = whole(Pane::code);
    return regions;
}

// Draws the splitters between the panes; a double click restores the default rule.
void draw_splitters(State& state) {
    Panes& panes = state.panes;
    const Regions regions = regions_of(state);
    const Rect& work = regions.work;
    const Rect &canvas = regions.canvas, &problems = regions.problems;
    const Rect &preview = regions.preview, &code = regions.code;
    const bool side = preview.size.x > 0 && canvas.size.x > 0, below = problems.size.y > 0;
    const bool halves = preview.size.y > 0 && code.size.y > 0;
    const ImVec2 end = work.at + work.size;
    if (below && canvas.size.x > 0)
        draw_splitter({"##split-problems", Rect{problems.at, {problems.size.x, 1}}, false,
                       panes.problems, problems.at.y + problems.size.y, work.size.y});
    if (halves)
        draw_splitter({"##split-preview", Rect{code.at, {code.size.x, 1}}, false, panes.preview,
                       preview.at.y, work.size.y});
    if (side)
        draw_splitter({"##split-side", Rect{preview.at, {1, work.size.y}}, true, panes.side, end.x,
                       work.size.x});
}

}  // namespace wrinkle::editor
