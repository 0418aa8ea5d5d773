// Strip for a background task: name, progress and a cancel button; or, after a failure, the reason
// with buttons to try again and to close.
#include <algorithm>
#include <cmath>

#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float bar_width = 240, bar_height = 8;

// Draws the fraction `part`, 0 to 1; below 0 it is unknown and a moving segment is drawn.
void draw_bar(ImDrawList& list, ImVec2 at, float part) {
    const ImVec2 end = at + ImVec2(bar_width, bar_height);
    list.AddRectFilled(at, end, theme::field, 4);
    constexpr float piece = 0.25F;
    const auto time = static_cast<float>(ImGui::GetTime());
    const float from = part < 0 ? (1 - piece) * (0.5F + 0.5F * std::sin(time * 2)) : 0;
    const float to = part < 0 ? from + piece : part;
    if (to > from)
        list.AddRectFilled(at + ImVec2(bar_width * from, 0), {at.x + bar_width * to, end.y},
                           theme::accent, 4);
    list.AddRect(at, end, theme::control, 4);
}

// Moves the cursor so that buttons of this total width end at the right border.
void begin_buttons(float width) {
    ImGui::SetCursorPos({ImGui::GetWindowWidth() - width - 12, 6});
}

std::string words_of(const Task& task) {
    if (task.cancelled()) return "Stopping";
    const TaskProgress& progress = task.progress();
    const std::chrono::duration<double> time = TaskProgress::Clock::now() - progress.begun.load();
    return progress_words(progress.done, progress.total, time.count(), task.order().unit);
}

void draw_running(State& state, const Task& task) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetWindowPos();
    const Fonts& fonts = state.fonts;
    const std::string words = words_of(task);
    const float beside = text_width(fonts.regular(14), 14, words) + bar_width + 12 + 16 + 24 + 100;
    const float room = std::max(ImGui::GetWindowWidth() - beside, 60.0F);
    const std::string name = fitting(fonts.bold(16), 16, task.order().name, room);
    draw_text(list, fonts.bold(16), 16, at + ImVec2(12, 12), theme::text, name);
    const float x = at.x + 12 + text_width(fonts.bold(16), 16, name) + 16;
    const uint64_t done = task.progress().done, total = task.progress().total;
    const float part =
        total > 1 && done > 0 ? static_cast<float>(done) / static_cast<float>(total) : -1.0F;
    draw_bar(list, {x, at.y + 16}, part);
    draw_text(list, fonts.regular(14), 14, {x + bar_width + 12, at.y + 13}, theme::text_dim, words);
    begin_buttons(88);
    if (button(state, "Cancel", "task:cancel", false, {88, 28})) cancel_task(state);
}

void draw_failed(State& state) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetWindowPos();
    list.AddRectFilled(at + ImVec2(0, 1), at + ImVec2(4, 40), theme::error);
    draw_error(list, at + ImVec2(22, 20), 16, theme::error);
    ImFont* font = state.fonts.regular(16);
    const float room = ImGui::GetWindowWidth() - 40 - 212;
    draw_text(list, font, 16, at + ImVec2(40, 12), theme::text,
              fitting(font, 16, state.tasks.failed, room));
    begin_buttons(192);
    const bool again = button(state, "Try again", "task:again", false, {96, 28});
    ImGui::SameLine(0, 8);
    const bool close = button(state, "Close", "task:close", false, {88, 28});
    if (again) return try_task_again(state);
    if (close) state.tasks.failed.clear();
}

}  // namespace

void draw_task(State& state) {
    const ImVec2 at = ImGui::GetWindowPos();
    ImGui::GetWindowDrawList()->AddLine(at, at + ImVec2(ImGui::GetWindowWidth(), 0), theme::border);
    if (state.tasks.running)
        draw_running(state, *state.tasks.running);
    else
        draw_failed(state);
}

}  // namespace wrinkle::editor
