#include "editor/view/panels/host_dialog.h"

#include <imgui_stdlib.h>

#include "editor/model/hosts/host_export.h"
#include "editor/model/hosts/repeated_exports.h"
#include "editor/model/words.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/dialog_rows.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

constexpr float host_wide = 560, host_padding = 24;
constexpr float host_control_wide = host_wide - 2 * host_padding - label_wide;

// Chooses the host, with the choices of its export that is repeated if there is one.
void choose_host(State& state, const Host& host) {
    HostDialog& dialog = state.host_dialog;
    const HostChoices* repeated = find_repeated_export(state, host);
    dialog.repeat = repeated != nullptr;
    if (repeated) dialog.choices = *repeated;
    dialog.choices.host = &host;
    if (!repeated) dialog.choices.into = usual_folder(state, host);
}

// Draws all hosts in two columns. Returns true if one was double-clicked.
bool draw_hosts(State& state) {
    constexpr float gap = 8, host_tall = 28, each_wide = (host_control_wide - gap) / 2;
    begin_control(state.fonts, "Host", "A double click exports");
    ImGui::BeginGroup();
    bool taken = false;
    for (size_t i = 0; i < hosts().size(); ++i) {
        const Host& host = hosts()[i];
        if (i % 2 == 1) ImGui::SameLine(0, gap);
        const bool chosen = state.host_dialog.choices.host == &host;
        if (button(state, std::string(host.label).c_str(), "host:to:" + std::string(host.name),
                   chosen, {each_wide, host_tall}))
            choose_host(state, host);
        taken |= ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
    }
    ImGui::EndGroup();
    return taken;
}

// Returns true on Enter.
bool draw_into_row(State& state) {
    HostChoices& choices = state.host_dialog.choices;
    begin_control(state.fonts, "Into", "A folder; ~ is the home folder");
    std::string text = choices.into.string();
    const bool entered = draw_control(state, "host:into", host_control_wide - 112, [&] {
        return ImGui::InputTextWithHint("##into", "A folder", &text,
                                        ImGuiInputTextFlags_EnterReturnsTrue);
    });
    choices.into = text;
    ImGui::SameLine(0, 8);
    if (button(state, "Browse...", "host:browse", false, {104, 0}))
        browse(state, Browser::Purpose::host_into, output_folder(state, choices));
    return entered;
}

// Returns true when the dialog is to be closed. `entered`: by Enter in a field, or a double click.
bool draw_host_buttons(State& state, bool entered) {
    const bool ready = why_no_host_export(state).empty();
    const bool on_top = !ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    ImGui::BeginDisabled(!ready);
    ImGui::PushStyleColor(ImGuiCol_Button, theme::accent_fill);
    ImGui::PushStyleColor(ImGuiCol_Text, theme::on_accent);
    bool go = button(state, "Export", "host:start", false, {104, 28});
    ImGui::PopStyleColor(2);
    ImGui::EndDisabled();
    const bool enter =
        entered || (on_top && !ImGui::IsAnyItemActive() && is_pressed(ImGuiKey_Enter, false));
    go |= enter && ready && !state.host_dialog.opening;
    ImGui::SameLine();
    const bool cancel = button(state, "Cancel", "host:cancel", false, {104, 28});
    if (go) {
        state.keeping.settings.host = state.host_dialog.choices.host->name;
        repeat_export(state, state.host_dialog.choices, state.host_dialog.repeat);
        start_host_export(state, state.host_dialog.choices);
    }
    return go || cancel || (on_top && is_pressed(ImGuiKey_Escape, false));
}

bool draw_host_rows(State& state) {
    HostChoices& choices = state.host_dialog.choices;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_text(*ImGui::GetWindowDrawList(), state.fonts.bold(24), 24, at, theme::text,
              "Export to a host");
    ImGui::Dummy({1, 32});
    bool entered = draw_hosts(state);
    begin_control(state.fonts, "Mesh");
    choose_mesh(state, "host", choices.mesh, host_control_wide, Browser::Purpose::host_mesh);
    begin_control(state.fonts, "Maps", "Side of baked maps, in texels");
    draw_numbers(state, "host:size", host_sizes, choices.size, host_control_wide,
                 [](uint32_t texels) { return grouped(texels) + " px"; });
    entered |= draw_into_row(state);
    begin_control(state.fonts, "Repeat", "Until another graph is opened");
    draw_control(state, "host:repeat", 0, [&] {
        return ImGui::Checkbox("Export again at every save", &state.host_dialog.repeat);
    });
    constexpr float wrap = host_wide - host_padding;
    const std::string why = why_no_host_export(state);
    write_paragraph(why.empty() ? theme::text_dim : theme::warn,
                    why.empty() ? std::string(choices.host->doc) + "." : why, wrap);
    if (!choices.preset.empty())
        write_paragraph(theme::text_dim, "With preset " + choices.preset + ".", wrap);
    ImGui::Dummy({0, 8});
    return draw_host_buttons(state, entered);
}

}  // namespace

std::string why_no_host_export(const State& state) {
    if (state.host_dialog.choices.into.empty()) return "Enter a folder.";
    if (state.built.problems.has_errors())
        return "The graph has errors. They are in the list of problems.";
    if (state.tasks.running) return state.tasks.running->order().name + " is not done yet.";
    return {};
}

void open_host_dialog(State& state) {
    const Host* last = find_host(state.keeping.settings.host);
    state.host_dialog = {};
    HostChoices& choices = state.host_dialog.choices;
    choices.mesh = state.view.preview_view.mesh;
    choices.preset = state.view.preview_request.preset;
    choose_host(state, last ? *last : hosts().front());
    state.host_dialog.open = state.host_dialog.opening = true;
}

void draw_host_dialog(State& state) {
    HostDialog& dialog = state.host_dialog;
    if (!dialog.open || state.question.open() || state.browser.purpose != Browser::Purpose::none)
        return;
    const Dialog shown("##host", {host_wide, 0}, {host_padding, 20}, 8);
    if (!shown) return;
    const bool done = draw_host_rows(state);
    dialog.opening = false;
    if (done) dialog.open = false;
    if (done || state.browser.purpose != Browser::Purpose::none) ImGui::CloseCurrentPopup();
}

}  // namespace wrinkle::editor
