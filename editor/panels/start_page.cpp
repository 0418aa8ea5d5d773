#include "editor/panels/start_page.h"

#include <algorithm>

#include "editor/commands/commands.h"
#include "editor/look/draw.h"
#include "editor/look/theme.h"
#include "editor/panels/file_actions.h"
#include "editor/panels/panels.h"
#include "editor/panels/samples.h"

namespace wrinkle::editor {
namespace {

constexpr float column = 720, drop_tall = 160;
constexpr float card_width = 168, card_tall = 140, gap = 16;

void dash(ImDrawList& list, ImVec2 from, ImVec2 to) {
    const ImVec2 whole = to - from;
    const float length = std::max(std::abs(whole.x), std::abs(whole.y));
    for (float at = 0; at < length; at += 12)
        list.AddLine(from + whole * (at / length),
                     from + whole * (std::min(at + 7, length) / length), theme::control, 1.5F);
}

void draw_drop_area(State& state, float width) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), end = at + ImVec2(width, drop_tall);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, end, theme::panel, 8);
    dash(list, at, {end.x, at.y});
    dash(list, {end.x, at.y}, end);
    dash(list, {at.x, end.y}, end);
    dash(list, at, {at.x, end.y});
    const auto centered = [&](const char* words, ImFont* font, float size, float y, ImU32 color) {
        const float x = (width - text_width(font, size, words)) / 2;
        draw_text(list, font, size, at + ImVec2(x, y), color, words);
    };
    centered("Drop two images here to layer them", state.fonts.bold(24), 24, 54, theme::text);
    centered("Normal maps, heights, slopes: their pixels say which. I chooses one by name.",
             state.fonts.regular(16), 16, 90, theme::text_dim);
    state.targets.add("start:drop", {at.x, at.y, end.x, end.y});
    ImGui::Dummy({width, drop_tall});
}

void draw_buttons(State& state) {
    if (button(state, "New graph", "start:new", true, {132, 28})) state.start.left = true;
    for (const char* id : {"open", "recover"}) {
        const Command* command = find_command(id);
        if (!command || !command->enabled(state)) continue;
        ImGui::SameLine(0, 8);
        const std::string title(command->title);
        if (button(state, title.c_str(), std::string("start:") + id)) command->run(state);
    }
}

// True when it was clicked.
bool draw_card(State& state, const Sample& sample) {
    const ImVec2 at = ImGui::GetCursorScreenPos(), size(card_width, card_tall);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool clicked = ImGui::InvisibleButton("card", size);
    state.targets.add("sample:" + sample.file.stem().string(),
                      {at.x, at.y, at.x + size.x, at.y + size.y});
    const bool hovered = ImGui::IsItemHovered();
    list.AddRectFilled(at, at + size, theme::node, 6);
    constexpr float tall = 92;
    const uint32_t picture = ImGui::IsItemVisible() ? state.thumbnails.of(sample.picture) : 0;
    if (picture)
        list.AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(picture)),
                             at + ImVec2(1, 1), at + ImVec2(card_width - 1, tall), {0, 0.77F},
                             {1, 0.23F}, IM_COL32_WHITE, 6, ImDrawFlags_RoundCornersTop);
    list.AddRect(at, at + size, hovered ? theme::accent : theme::border, 6, 0, hovered ? 2 : 1);
    ImFont* bold = state.fonts.bold(16);
    draw_text(list, bold, 16, at + ImVec2(10, tall + 6), theme::text,
              fitting(bold, 16, sample.name, card_width - 20));
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(10, tall + 26), theme::text_dim,
              counted(sample.nodes, "node"));
    if (hovered) ImGui::SetTooltip("%s", sample.name.c_str());
    return clicked;
}

void draw_samples(State& state, float width) {
    if (!state.start.read) {
        state.start.samples = list_samples(samples_folder());
        state.start.read = true;
    }
    const std::vector<Sample>& samples = state.start.samples;
    if (samples.empty()) return;
    ImGui::PushFont(state.fonts.bold(18));
    ImGui::TextUnformatted("Samples");
    ImGui::PopFont();
    const int columns = std::max(static_cast<int>((width + gap) / (card_width + gap)), 1);
    std::filesystem::path taken;
    for (size_t i = 0; i < samples.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (static_cast<int>(i) % columns != 0) ImGui::SameLine(0, gap);
        if (draw_card(state, samples[i])) taken = samples[i].file;
        ImGui::PopID();
    }
    if (!taken.empty()) open_chosen(state, taken);
}

}  // namespace

bool is_at_start(const State& state) {
    return !state.start.left && state.path.empty() && state.document().nodes.empty() &&
           !state.history.can_undo() && !state.history.can_redo();
}

void draw_start_page(State& state) {
    const ImVec2 room = ImGui::GetContentRegionAvail();
    state.view.corner = ImGui::GetCursorScreenPos();
    state.view.extent = room;
    state.targets.add("canvas", {state.view.corner.x, state.view.corner.y,
                                 state.view.corner.x + room.x, state.view.corner.y + room.y});
    const float width = std::max(std::min(column, room.x - 48), 200.0F);
    ImGui::BeginChild("##start", room, false, ImGuiWindowFlags_NoNavInputs);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(8, gap));
    ImGui::Indent(std::max((room.x - width) / 2, 1.0F));
    ImGui::Dummy({1, std::max((room.y - 720) / 2, 16.0F)});
    draw_drop_area(state, width);
    draw_buttons(state);
    draw_samples(state, width);
    ImGui::Dummy({1, 16});
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

}  // namespace wrinkle::editor
