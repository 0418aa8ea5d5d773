// Popup for a wire dropped on a pin of another type: the reason, and node types to insert.
#include <algorithm>

#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float width = 440;

// Returns the index of the chosen row, or -1.
int draw_offered(State& state) {
    Offer& offer = state.offer;
    const int count = static_cast<int>(offer.choices.size());
    offer.chosen = moved_choice(offer.chosen, offer.choices.size());
    int taken = -1;
    for (int i = 0; i < count; ++i) {
        const Offer::Choice& choice = offer.choices[static_cast<size_t>(i)];
        const std::string label = "Insert " + choice.type->title;
        if (button(state, label.c_str(), "offer:" + choice.type->id, i == offer.chosen,
                   {width - 24, 28}))
            taken = i;
        if (ImGui::IsItemHovered()) show_tooltip(beside_window(), choice.type->doc);
    }
    const bool enter = is_pressed(ImGuiKey_Enter, false);
    return enter && !offer.opening && count > 0 ? offer.chosen : taken;
}

}  // namespace

void draw_offer(State& state) {
    Offer& offer = state.offer;
    if (!offer.open) return;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const ImVec2 at(std::clamp(offer.at.x + 12, 0.0F, std::max(room.x - width, 0.0F)),
                    std::clamp(offer.at.y + 12, 0.0F, std::max(room.y - 160, 0.0F)));
    const FixedWindow window("##offer", at, {width, 0},
                             {.padding = {12, 8},
                              .ground = theme::node,
                              .border = theme::line,
                              .rounding = 8,
                              .opening = offer.opening});
    write_paragraph(theme::text, offer.why, width - 12);
    const int taken = draw_offered(state);
    offer.opening = false;
    if (taken >= 0)
        accept_offer(state, static_cast<size_t>(taken));
    else if (window.has_lost_focus() || is_pressed(ImGuiKey_Escape))
        offer = {};
}

}  // namespace wrinkle::editor
