#include "editor/view/panels/bake_dialog.h"

#include <algorithm>

#include "editor/model/bake/bake.h"
#include "editor/model/words.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr size_t max_names = 4;  // most files that are listed by name

// Draws the central square of the current preview image.
void draw_object(const PreviewState& preview, ImVec2 at) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end = at + ImVec2(preview_side, preview_side);
    list.AddRectFilled(at, end, theme::rgb(0x212326), 4);
    const PreviewImage* shown = preview.preview ? &preview.preview->shown() : nullptr;
    if (shown && shown->texture && shown->width > 0 && shown->height > 0) {
        const auto wide = static_cast<float>(shown->width),
                   tall = static_cast<float>(shown->height);
        const float side = std::min(wide, tall), x = side / wide / 2, y = side / tall / 2;
        list.AddImageRounded(texture_id(shown->texture), at, end, {0.5F - x, 0.5F + y},
                             {0.5F + x, 0.5F - y}, IM_COL32_WHITE, 4);
    }
    list.AddRect(at, end, theme::border, 4);
}

std::string what_is_replaced(const State& state) {
    BakeChoices choices = state.bake_dialog.choices;
    choices.into = output_folder(state, choices);
    std::vector<std::string> there;
    std::error_code error;
    for (const fs::path& file : baked_files(choices))
        if (fs::exists(file, error)) there.push_back(file.filename().string());
    if (there.empty()) return {};
    if (there.size() > max_names) return counted(there.size(), "file") + " there are replaced.";
    return listed(there) +
           (there.size() == 1 ? " is there already and is" : " are there already and are") +
           " replaced.";
}

void draw_consequences(State& state) {
    BakeDialog& dialog = state.bake_dialog;
    dialog.replaces = what_is_replaced(state);
    const std::string why = why_no_bake(state);
    constexpr float wrap = bake_wide - bake_padding;
    write_paragraph(why.empty() ? theme::text_dim : theme::warn,
                    why.empty() ? what_is_written(dialog.choices) : why, wrap);
    write_paragraph(theme::warn, dialog.replaces, wrap);
    if (state.view.preview_view.scale != 1)
        write_paragraph(theme::text_dim, "The mesh is taken in its own size, not in the preview's.",
                        wrap);
    ImGui::Dummy({0, 8});
}

// Button at the right that copies the same bake as a shell command.
void draw_copy_button(State& state) {
    const BakeDialog& dialog = state.bake_dialog;
    std::string why;
    const bool any = !asked_maps(dialog.choices, why).empty() && why.empty() && !state.path.empty();
    ImGui::SameLine(bake_wide - bake_padding - 136);
    ImGui::BeginDisabled(!any);
    const bool copy = button(state, "Copy command", "bake:copy", false, {136, 28});
    ImGui::EndDisabled();
    const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
    const About about = last_item();
    if (!any && hovered) show_tooltip(about, "Needs a saved graph and a chosen map");
    if (!any || (!copy && !hovered)) return;
    BakeChoices choices = dialog.choices;
    choices.into = fs::absolute(output_folder(state, choices)).lexically_normal();
    const std::string command = bake_command(choices, fs::absolute(state.path));
    if (copy) {
        ImGui::SetClipboardText(command.c_str());
        state.status = "The command is on the clipboard. It bakes the graph as it is saved.";
    }
    if (const Tooltip tip(about, bake_wide); tip) ImGui::TextUnformatted(command.c_str());
}

// Returns true when the dialog is to be closed.
bool draw_bake_buttons(State& state, bool entered) {
    const bool ready = why_no_bake(state).empty();
    const bool alone = !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    ImGui::BeginDisabled(!ready);
    ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_fill);
    ImGui::PushStyleColor(ImGuiCol_Text, theme::on_accent);
    bool bake = button(state, "Bake", "bake:start", false, {104, 28});
    ImGui::PopStyleColor(2);
    ImGui::EndDisabled();
    const bool enter =
        entered || (alone && !ImGui::IsAnyItemActive() && is_pressed(ImGuiKey_Enter, false));
    bake |= enter && ready && !state.bake_dialog.opening;
    ImGui::SameLine();
    const bool cancel = button(state, "Cancel", "bake:cancel", false, {104, 28});
    draw_copy_button(state);
    if (bake) start_bake(state, state.bake_dialog.choices);
    return bake || cancel || (alone && is_pressed(ImGuiKey_Escape, false));
}

bool draw_bake_rows(State& state) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.bold(24), 24, at, theme::text, "Bake maps");
    ImGui::Dummy({1, 32});
    draw_object(state, at + ImVec2(bake_wide - 2 * bake_padding - preview_side, 40));
    const float beside = ImGui::GetCursorPosY() + preview_side + 16;
    draw_map_rows(state);
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), beside));
    const bool entered = draw_file_rows(state);
    draw_consequences(state);
    return draw_bake_buttons(state, entered);
}

}  // namespace

std::string why_no_bake(const State& state) {
    const BakeChoices& choices = state.bake_dialog.choices;
    std::string why;
    const std::vector<AskedMap> asked = asked_maps(choices, why);
    if (!why.empty()) return why;
    if (asked.empty()) return "Choose a map.";
    if (!(choices.tuning.scale > 0)) return "The scale is a number greater than 0.";
    if (choices.into.empty()) return "Say where the maps go.";
    if (state.built.problems.has_errors())
        return "The graph has errors. They are in the list of problems.";
    if (state.tasks.running) return state.tasks.running->order().name + " is not done yet.";
    return {};
}

std::string what_is_written(const BakeChoices& choices) {
    const std::vector<fs::path> files = baked_files(choices, choices.udim ? ".1001" : "");
    const bool many = files.size() > max_names;
    std::vector<std::string> names;
    for (const fs::path& file : files)
        names.push_back(file.filename().string());
    std::string text = "Writes " + (many ? counted(files.size(), "map") : listed(names));
    if (!choices.preset.empty()) text += " with preset " + choices.preset;
    if (!choices.one_file()) text += " into " + choices.into.string();
    return text + (choices.udim ? ", and so on for each tile." : ".");
}

void open_bake_dialog(State& state) {
    state.bake_dialog = {};
    state.bake_dialog.choices = usual_bake(state, state.view.preview_view.mesh);
    state.bake_dialog.choices.preset = state.view.preview_request.preset;
    state.bake_dialog.open = state.bake_dialog.opening = true;
}

void draw_bake_dialog(State& state) {
    BakeDialog& dialog = state.bake_dialog;
    if (!dialog.open || state.question.open() || state.browser.purpose != Browser::Purpose::none)
        return;
    const float room = ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowSizeConstraints({bake_wide, 0}, {bake_wide, room - 16});
    const Dialog shown("##bake", {bake_wide, 0}, {bake_padding, 20}, 8);
    if (!shown) return;
    const bool done = draw_bake_rows(state);
    dialog.opening = false;
    if (done) dialog = {};
    if (done || state.browser.purpose != Browser::Purpose::none) ImGui::CloseCurrentPopup();
}

}  // namespace wrinkle::editor
