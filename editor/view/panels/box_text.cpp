// In-place editor for the text of a note or the title of a frame.
#include "editor/view/panels/panels.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"

namespace wrinkle::editor {
namespace {

// Returns true when editing is finished.
bool draw_entry(State& state, ImVec2 size) {
    BoxText& entry = state.box_text;
    if (entry.opening) focus_field(state);
    ImGui::SetNextItemWidth(size.x);
    const bool done = entry.box.note
                          ? ImGui::InputTextMultiline("##text", &entry.text, size,
                                                      ImGuiInputTextFlags_CtrlEnterForNewLine |
                                                          ImGuiInputTextFlags_EnterReturnsTrue)
                          : ImGui::InputText("##text", &entry.text,
                                             ImGuiInputTextFlags_EnterReturnsTrue |
                                                 ImGuiInputTextFlags_AutoSelectAll);
    note_field(state);
    return done;
}

}  // namespace

void draw_box_text(State& state) {
    BoxText& entry = state.box_text;
    if (!entry.open) return;
    const Box* box = find_box(state.document(), entry.box);
    if (!box) {
        entry = {};
        return;
    }
    const Extent extent = extent_of(state, entry.box, *box);
    const ImVec2 low = to_screen(state.view, extent.low), high = to_screen(state.view, extent.high);
    const ImVec2 size(std::max(high.x - low.x, 160.0F), std::max(high.y - low.y, 64.0F));
    const FixedWindow window("##box-text", low, {0, 0},
                             {.padding = {4, 4},
                              .ground = theme::panel,
                              .border = theme::accent,
                              .opening = entry.opening});
    const bool done = draw_entry(state, size - ImVec2(8, 8));
    entry.opening = false;
    if (is_pressed(ImGuiKey_Escape))
        entry = {};
    else if (done || window.has_lost_focus())
        accept_box_text(state);
}

}  // namespace wrinkle::editor
