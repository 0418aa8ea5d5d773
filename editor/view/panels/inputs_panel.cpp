// Inputs of the graph and its presets. Values are set in the chosen preset, or as defaults.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "editor/model/document/inputs.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/panels.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

constexpr float side_head = 38, preset_tall = 40;
constexpr const char* no_preset = "Defaults";

std::string& chosen_preset(State& state) {
    return state.view.preview_request.preset;
}

// Returns the texture; 0 while the list is closed.
uint32_t image_of(State& state, const std::string& preset) {
    if (!state.inputs_panel.lists_presets) return 0;
    return state.graph_images.of({state.model, state.document(), preset},
                                 (state.follow.first << 32) + state.history.serial());
}

void choose_preset(State& state, float width) {
    std::vector<Item> items{{no_preset, "preset:defaults", {}, image_of(state, "")}};
    for (const Preset& preset : state.document().presets)
        items.push_back({preset.name, "preset:" + preset.name, {}, image_of(state, preset.name)});
    const std::string shown = chosen_preset(state).empty() ? no_preset : chosen_preset(state);
    const int picked = choose(state, "preset", shown, items, width);
    state.inputs_panel.lists_presets = state.targets.find("preset:defaults").has_value();
    if (picked == 0) chosen_preset(state).clear();
    if (picked > 0) chosen_preset(state) = items[static_cast<size_t>(picked)].label;
}

void save_preset(State& state) {
    const std::string name = state.inputs_panel.text;
    state.status = preset_name_problem(state.document(), name);
    if (!state.status.empty()) return;
    state.commit("Save preset " + name,
                 with_copied_preset(state.document(), name, chosen_preset(state)));
    chosen_preset(state) = name;
    ImGui::CloseCurrentPopup();
}

void draw_save_popup(State& state) {
    const PanelPopup popup("##new-preset");
    if (!popup) return;
    if (ImGui::IsWindowAppearing()) focus_field(state);
    ImGui::TextDisabled("A new preset with the values shown");
    ImGui::SetNextItemWidth(220);
    const bool entered = ImGui::InputTextWithHint(
        "##name", "Name", &state.inputs_panel.text,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    note_field(state);
    name_item(state, "preset:name");
    if (entered) save_preset(state);
}

void draw_presets(State& state) {
    constexpr float save = 92, remove = 28, margin = 12;
    ImGui::SetCursorPos({margin, side_head + 4});
    choose_preset(state, ImGui::GetWindowWidth() - save - remove - 2 * margin - 8);
    ImGui::SameLine(0, 4);
    if (button(state, "Save as...", "preset:save", false, {save, 0})) {
        state.inputs_panel.text = free_preset_name(state.document());
        ImGui::OpenPopup("##new-preset");
    }
    draw_save_popup(state);
    ImGui::SameLine(0, 4);
    const std::string name = chosen_preset(state);
    if (!icon_button(state, "delete", "preset:delete",
                     name.empty() ? "The defaults cannot be deleted." : "Delete preset " + name,
                     !name.empty()))
        return;
    state.commit("Delete preset " + name, remove_preset(state.document(), name));
    chosen_preset(state).clear();
}

void draw_side_title(State& state, const char* title, const char* target, ImVec2& at, bool inputs) {
    const bool shown = state.inputs_panel.shown == inputs;
    ImFont* font = shown ? state.fonts.bold(18) : state.fonts.regular(18);
    const float width = text_width(font, 18, title);
    ImGui::SetCursorScreenPos(at - ImVec2(4, 4));
    const Area area = area_button(state, target, {width + 8, 28});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, font, 18, at, shown || area.hovered ? theme::text : theme::text_dim, title);
    if (shown)
        list.AddRectFilled({at.x, area.high.y - 1}, {at.x + width, area.high.y + 1}, theme::accent);
    if (area.pressed) state.inputs_panel.shown = inputs;
    at.x += width + 16;
}

}  // namespace

float draw_side_titles(State& state) {
    const ImVec2 corner = ImGui::GetWindowPos();
    ImVec2 at = corner + ImVec2(12, 10);
    draw_side_title(state, "Code", "side:code", at, false);
    draw_side_title(state, "Inputs", "side:inputs", at, true);
    return at.x - corner.x;
}

void draw_inputs(State& state) {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ImGui::GetWindowDrawList()->AddRectFilled(at, at + size, theme::panel);
    const float left = draw_side_titles(state);
    const size_t count = state.document().inputs.size();
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.regular(14), 14, at + ImVec2(left, 13),
              theme::text_dim, counted(count, "input"));
    if (count == 0) {
        ImGui::SetCursorPos({12, side_head + 8});
        write_paragraph(theme::text_dim,
                        "The graph has no inputs. Point at a value on a card and press E: it "
                        "becomes an input, which presets and other programs can set.",
                        size.x - 12);
        return;
    }
    draw_presets(state);
    ImGui::SetCursorPos({12, side_head + preset_tall});
    ImGui::BeginChild("##inputs", {size.x - 12, size.y - side_head - preset_tall}, false,
                      ImGuiWindowFlags_NoNavInputs);
    draw_input_rows(state);
    ImGui::EndChild();
}

}  // namespace wrinkle::editor
