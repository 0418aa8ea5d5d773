#include <algorithm>
#include <cmath>

#include "editor/look/draw.h"
#include "editor/look/theme.h"
#include "editor/panels/panels.h"
#include "mesh/shapes.h"

namespace wrinkle::editor {
namespace {

void draw_head(State& state) {
    const ImVec2 at = ImGui::GetWindowPos();
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.bold(18), 17, at + ImVec2(12, 8),
              theme::text, "Preview");
    ImGui::SetCursorPos({110, 5});
    PreviewView& view = state.view.preview_view;
    for (const Shape& shape : shapes()) {
        const std::string name(shape.name);
        if (button(state, name.c_str(), "mesh:" + name, view.mesh == name)) view.mesh = name;
        ImGui::SameLine(0, 4);
    }
    ImGui::NewLine();
    ImGui::SetCursorPosX(12);
    for (size_t i = 0; i < gpu::view_names().size(); ++i) {
        const std::string name(gpu::view_names()[i]);
        const auto which = static_cast<gpu::View>(i);
        if (button(state, name.c_str(), "view:" + name, view.view == which)) view.view = which;
        ImGui::SameLine(0, 4);
    }
    ImGui::NewLine();
}

void orbit(State& state) {
    PreviewView& view = state.view.preview_view;
    const ImGuiIO& io = ImGui::GetIO();
    if (ImGui::IsItemActive()) {
        view.yaw -= io.MouseDelta.x * 0.01F;
        view.pitch = std::clamp(view.pitch + io.MouseDelta.y * 0.01F, -1.5F, 1.5F);
    }
    if (ImGui::IsItemHovered() && io.MouseWheel != 0)
        view.distance = std::clamp(view.distance * std::pow(1.1F, -io.MouseWheel), 0.1F, 10.0F);
}

std::string first_reason(const State& state, const Diagnostics& drawing) {
    for (const Diagnostics* list :
         {&state.preview_problems, &state.built.problems, &state.built.live, &drawing})
        for (const Diagnostic& problem : list->list())
            if (problem.severity == Severity::error)
                return (problem.node.empty() ? "" : problem.node + ": ") + problem.message;
    return {};
}

void draw_strip(State& state, ImVec2 at, float width, const std::string& text) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, at + ImVec2(width, 28), theme::with_alpha(theme::canvas, 0.88F));
    list.AddRectFilled(at, at + ImVec2(4, 28), theme::warn);
    ImFont* font = state.fonts.regular(14);
    draw_text(list, font, 14, at + ImVec2(12, 7), theme::text, fitting(font, 14, text, width - 20));
}

}  // namespace

void draw_preview(State& state) {
    draw_head(state);
    ImGui::SetCursorPosX(0);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size = ImGui::GetContentRegionAvail();
    if (size.x < 1 || size.y < 1) return;
    ImGui::InvisibleButton("picture", size);
    state.targets.add("preview", {at.x, at.y, at.x + size.x, at.y + size.y});
    orbit(state);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, at + size, theme::rgb(0x282A2D));
    Diagnostics drawing;
    uint32_t picture = 0;
    const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
    if (state.preview)
        picture =
            state.preview->picture(state.view.preview_view, static_cast<int>(size.x * pixels.x),
                                   static_cast<int>(size.y * pixels.y), drawing);
    if (picture)
        list.AddImage(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(picture)), at, at + size,
                      {0, 1}, {1, 0});
    const std::string reason = first_reason(state, drawing);
    if (state.preview_stale)
        draw_strip(state, at, size.x,
                   (picture ? "Showing the last good picture. " : "No picture yet. ") + reason);
    else if (!reason.empty() && drawing.has_errors())
        draw_strip(state, at, size.x, reason);
}

}  // namespace wrinkle::editor
