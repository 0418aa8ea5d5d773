#include "editor/view/look/tooltip.h"

#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"

namespace wrinkle::editor {
namespace {

constexpr float gap = 8;

// The size is known only after drawing, so the corner nearest to `about` is positioned.
void place(const About& about, float wide) {
    const ImVec2 room = ImGui::GetIO().DisplaySize, mouse = ImGui::GetIO().MousePos;
    const bool upper = about.low.y + about.high.y < room.y;
    const bool right = about.high.x + gap + wide<room.x, left = about.low.x - gap - wide> 0;
    if (about.aside && (right || left))
        return ImGui::SetNextWindowPos(
            {right ? about.high.x + gap : about.low.x - gap, upper ? about.low.y : about.high.y},
            ImGuiCond_Always, {right ? 0.0F : 1.0F, upper ? 0.0F : 1.0F});
    ImGui::SetNextWindowPos({mouse.x, upper ? about.high.y + gap : about.low.y - gap},
                            ImGuiCond_Always,
                            {mouse.x < room.x / 2 ? 0.0F : 1.0F, upper ? 0.0F : 1.0F});
}

}  // namespace

About last_item() {
    return {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
}

About beside_window() {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    return {{low.x, ImGui::GetItemRectMin().y}, {low.x + size.x, ImGui::GetItemRectMax().y}, true};
}

Tooltip::Tooltip(const About& about, float wrap) : open_(!ImGui::IsAnyMouseDown()) {
    if (!open_) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(12, 8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 5);
    ImGui::PushStyleColor(ImGuiCol_PopupBg, theme::bar);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::line);
    place(about, wrap + 24);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(wrap);
}

Tooltip::~Tooltip() {
    if (!open_) return;
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
}

void show_tooltip(const About& about, std::string_view text) {
    if (const Tooltip tip(about); tip)
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void show_tooltip(const About& about, ImFont* bold, std::string_view title, std::string_view text) {
    const Tooltip tip(about);
    if (!tip) return;
    ImGui::PushFont(bold);
    ImGui::TextUnformatted(title.data(), title.data() + title.size());
    ImGui::PopFont();
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, theme::text_dim);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

}  // namespace wrinkle::editor
