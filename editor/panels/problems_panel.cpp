#include "editor/canvas/layout.h"
#include "editor/look/draw.h"
#include "editor/look/theme.h"
#include "editor/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float head_height = 28, row_height_of_problem = 44;

std::string counts(const Diagnostics& problems) {
    const size_t errors = problems.error_count(), all = problems.list().size();
    if (all == 0) return "No problems.";
    return counted(all - errors, "warning") + ", " + counted(errors, "error");
}

std::string place(const Diagnostic& problem) {
    std::string text = problem.expected;
    if (problem.where.line == 0) return text;
    if (!text.empty()) text += "   ";
    return text + problem.where.file + ", line " + std::to_string(problem.where.line) +
           ", column " + std::to_string(problem.where.column);
}

void show_node(State& state, const std::string& path) {
    const std::string id = path.substr(0, path.find('/'));
    if (!state.document().find(id)) return;
    state.view.selected = {id};
    fit(state.view, state.layout, true);
}

void draw_problem(State& state, const Diagnostic& problem, size_t index) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0F), row_height_of_problem - 4);
    ImGui::PushID(static_cast<int>(index));
    const bool clicked = ImGui::InvisibleButton("problem", size);
    ImGui::PopID();
    state.targets.add("problem:" + std::to_string(index + 1),
                      {at.x, at.y, at.x + size.x, at.y + size.y});
    list.AddRect(at, at + size, ImGui::IsItemHovered() ? theme::accent : theme::border, 6);
    const bool error = problem.severity == Severity::error;
    draw_warning(list, at + ImVec2(18, 20), 16, error ? theme::error : theme::warn);
    const Fonts& fonts = state.fonts;
    float x = 36;
    if (!problem.node.empty()) {
        draw_text(list, fonts.bold(16), 16, at + ImVec2(x, 4), theme::text, problem.node);
        x += text_width(fonts.bold(16), 16, problem.node) + 10;
    }
    draw_text(list, fonts.regular(16), 16, at + ImVec2(x, 4), theme::text,
              fitting(fonts.regular(16), 16, problem.message, size.x - x - 8));
    draw_text(list, fonts.regular(14), 14, at + ImVec2(36, 22), theme::text_dim,
              fitting(fonts.regular(14), 14, place(problem), size.x - 44));
    if (clicked) show_node(state, problem.node);
}

const Diagnostics& shown(const State& state) {
    return state.built.problems.list().empty() ? state.preview_problems : state.built.problems;
}

}  // namespace

float problems_height(const State& state) {
    return head_height + row_height_of_problem * static_cast<float>(shown(state).list().size());
}

void draw_problems(State& state) {
    const Diagnostics problems = shown(state);
    const ImVec2 at = ImGui::GetWindowPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, state.fonts.bold(18), 17, at + ImVec2(12, 5), theme::text, "Problems");
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(96, 7), theme::text_dim,
              counts(problems));
    if (problems.list().empty()) return;
    ImGui::SetCursorPosY(head_height);
    ImGui::BeginChild("##problems", {0, 0}, false, ImGuiWindowFlags_NoNavInputs);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(problems.list().size()), row_height_of_problem);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const auto index = static_cast<size_t>(i);
            draw_problem(state, problems.list()[index], index);
        }
    ImGui::EndChild();
}

}  // namespace wrinkle::editor
