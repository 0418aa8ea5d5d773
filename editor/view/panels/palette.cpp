#include "editor/view/panels/palette.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "editor/view/edit/edits.h"
#include "editor/view/input/input_queue.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float padding = 8, query_tall = 30, footer_tall = 30;
constexpr int rows_shown = 8;

// Words about a list: a row of it, the hint of the empty query, and the action of Enter.
struct Words {
    const char *row, *hint, *enter;
};
constexpr Words list_words[] = {{"node", "Search nodes", "place"},
                                {"node", "Search nodes", "show"},
                                {"command", "Search commands", "run"},
                                {"step", "Search steps", "return"}};
const Words& words_of(const Palette& palette) {
    return list_words[static_cast<size_t>(palette.list)];
}

bool has_single_lines(const Palette& palette) {
    return palette.list == Palette::List::commands || palette.list == Palette::List::steps;
}
float width_of(const Palette& palette) {
    return has_single_lines(palette) ? 480 : 288;
}
float row_tall(const Palette& palette) {
    return has_single_lines(palette) ? 32 : 46;
}

void add_chosen(State& state, const NodeType& type, ImVec2 at, const Palette& palette) {
    if (palette.at_selection) return add_node_to_selection(state, type, at);
    add_node_of_type(state, type, at, palette.wire);
}

void add_subgraph(State& state, const std::string& file, ImVec2 at, const Palette& palette) {
    const std::optional<NodeType> type = subgraph_type(state.model, file, state.status);
    if (!type) return;
    add_chosen(state, *type, at, palette);
    if (!type_fits(*type, palette.wire))
        state.status = file + " has no port for " + std::string(name_of(palette.wire.type)) + ".";
}

void add_from_library(State& state, const LibraryEntry& entry, ImVec2 at, const Palette& palette) {
    const std::string file = copy_from_library(state, entry);
    if (!file.empty()) add_subgraph(state, file, at, palette);
}

void choose(State& state, const PaletteRow& row) {
    const Palette palette = state.palette;
    const auto entry = row.entry ? std::optional(*row.entry) : std::nullopt;  // of the old palette
    if (!row.off.empty()) {
        state.status = row.off;
        return;
    }
    state.palette = {};
    if (!row.node.empty()) {
        state.view.selected = {row.node};
        return show_nodes(state, true);
    }
    if (row.step) {
        state.status = (*row.step == 0 ? "Back at the start" : "Back at: " + row.title);
        return go_to_step(state, *row.step);
    }
    if (row.command) {
        note_use(state.recent.commands, row.command->id);
        return row.command->run(state);
    }
    const ImVec2 at = to_canvas(state.view, palette.at);
    if (!row.graph.empty()) return add_subgraph(state, row.graph, at, palette);
    if (entry) return add_from_library(state, *entry, at, palette);
    note_use(state.recent.nodes, row.type->id);
    add_chosen(state, *row.type, at, palette);
}

// Highlights the letters that match the query.
void draw_title(const Fonts& fonts, ImDrawList& list, ImVec2 at, const PaletteRow& row) {
    const std::string_view title = row.title;
    size_t next = 0;
    for (size_t i = 0; i < title.size();) {
        const bool matched = next < row.letters.size() && row.letters[next] == i;
        size_t end = i;
        while (end < title.size() &&
               (next < row.letters.size() && row.letters[next] == end) == matched) {
            if (matched) ++next;
            ++end;
        }
        ImFont* font = matched || row.is_node() ? fonts.bold(16) : fonts.regular(16);
        const ImU32 color = !row.off.empty() ? theme::text_off
                            : matched        ? theme::accent
                                             : theme::text;
        draw_text(list, font, 16, at, color, title.substr(i, end - i));
        at.x += text_width(font, 16, title.substr(i, end - i));
        i = end;
    }
}

void draw_output(ImDrawList& list, const NodeType* type, ImVec2 at, bool chosen) {
    const Port* port = first_output(type);
    if (!port) return;
    if (chosen) list.AddCircleFilled(at, 11, theme::panel);
    draw_pin(list, port->type, at, 6, theme::of(port->type), true,
             chosen ? theme::panel : theme::node);
}

constexpr float star_side = 24;

void draw_star(ImDrawList& list, ImVec2 middle, bool filled) {
    constexpr int corners = 10;
    constexpr float outer = 6, inner = 2.7F;
    std::array<ImVec2, corners> path;
    for (int i = 0; i < corners; ++i) {
        const float angle = static_cast<float>(i) * 0.628319F;  // a tenth of a turn, from the top
        const float radius = i % 2 == 0 ? outer : inner;
        path[static_cast<size_t>(i)] =
            middle + ImVec2(std::sin(angle) * radius, -std::cos(angle) * radius);
    }
    if (!filled)
        return list.AddPolyline(path.data(), corners, theme::text_dim, ImDrawFlags_Closed, 1);
    for (size_t i = 0; i < corners; ++i)
        list.AddTriangleFilled(middle, path[i], path[(i + 1) % corners], theme::accent);
}

// Draws the image of a graph; returns its width with the gap, 0 if there is none.
float draw_graph_image(State& state, const PaletteRow& row, ImVec2 low) {
    GraphFile wanted{{}, {}, state.registry};
    if (row.entry)
        wanted.file = row.entry->file;
    else if (!row.graph.empty())
        wanted.file = state.folder() / row.graph, wanted.root = state.root();
    const uint32_t texture = wanted.file.empty() ? 0 : state.graph_images.of(wanted);
    if (!texture) return 0;
    constexpr float side = 36;
    const ImVec2 at = low + ImVec2(5, 5);
    ImGui::GetWindowDrawList()->AddImage(texture_id(texture), at, at + ImVec2(side, side), {0, 1},
                                         {1, 0});
    return 48;
}

void draw_node_row(State& state, const PaletteRow& row, ImVec2 low, ImVec2 high, bool chosen) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImFont* small = state.fonts.regular(14);
    const float image = draw_graph_image(state, row, low), left = std::max(image, 38.0F);
    if (image == 0) draw_output(list, row.type, {low.x + 18, (low.y + high.y) / 2}, chosen);
    draw_title(state.fonts, list, low + ImVec2(left, 5), row);
    const std::string doc = fitting(small, 14, row.doc, high.x - low.x - left - star_side);
    draw_text(list, small, 14, low + ImVec2(left, 24), theme::text_dim, doc);
    if (chosen && doc != row.doc) show_tooltip(beside_window(), row.doc);
    if (row.favorite || (chosen && !row.added_type().empty()))
        draw_star(list, high - ImVec2(star_side, star_side) * 0.5F, row.favorite);
    if (chosen)
        draw_text(list, small, 14, {high.x - 10, low.y + 6}, theme::text_dim, "Enter", true);
}

void draw_row(State& state, const PaletteRow& row, ImVec2 low, ImVec2 high, bool chosen) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen) list.AddRectFilled(low, high, theme::accent_soft, 4);
    if (row.is_node()) return draw_node_row(state, row, low, high, chosen);
    ImFont* small = state.fonts.regular(14);
    draw_title(state.fonts, list, low + ImVec2(10, 8), row);
    const float key = text_width(small, 14, row.key);
    draw_text(list, small, 14, {high.x - 10, low.y + 9}, theme::text_dim, row.key, true);
    const float name = text_width(state.fonts.bold(16), 16, row.title) + 24;
    draw_text(
        list, small, 14, low + ImVec2(name, 9), theme::text_off,
        fitting(small, 14, row.off.empty() ? row.doc : row.off, high.x - low.x - name - key - 24));
}

void move_choice(Palette& palette, int count) {
    const float wheel = ImGui::GetIO().MouseWheel;
    const int before = palette.chosen;
    palette.chosen = moved_choice(palette.chosen, static_cast<size_t>(count), rows_shown);
    if (palette.chosen != before || palette.first > palette.chosen)
        palette.first = std::clamp(palette.first, palette.chosen - rows_shown + 1, palette.chosen);
    if (ImGui::IsWindowHovered()) palette.first -= static_cast<int>(wheel * 3);
    palette.first = std::clamp(palette.first, 0, std::max(count - rows_shown, 0));
}

// Returns the index of the chosen row, or -1.
int draw_palette_rows(State& state, const std::vector<PaletteRow>& rows) {
    Palette& palette = state.palette;
    int taken = -1;
    const int last = std::min(palette.first + rows_shown, static_cast<int>(rows.size()));
    for (int i = palette.first; i < last; ++i) {
        const PaletteRow& row = rows[static_cast<size_t>(i)];
        const Area area =
            area_button(state, row.target, {width_of(palette) - 2 * padding, row_tall(palette)});
        const ImVec2 star = area.high - ImVec2(star_side, star_side);
        const bool adds = !row.added_type().empty();
        const bool on_star = adds && ImGui::IsMouseHoveringRect(star, area.high, false);
        if (adds) name_area(state, row.target + ":favorite", star, area.high);
        if (area.pressed && on_star) toggle_favorite(state, row);
        if (area.pressed && !on_star) taken = i;
        const ImVec2 moved = ImGui::GetIO().MouseDelta;
        if (area.hovered && (moved.x != 0 || moved.y != 0)) palette.chosen = i;
        draw_row(state, row, area.low, area.high, i == palette.chosen);
    }
    return taken;
}

// Returns the active filter: "takes gradient"; "" if there is none.
std::string filter_of(const Palette& palette) {
    if (palette.list != Palette::List::types || palette.wire.kind != Gesture::Kind::wire) return {};
    if (palette.all_types) return "all types";
    return (palette.wire.from_output ? "takes " : "gives ") +
           std::string(name_of(palette.wire.type));
}

int on_query_tab(ImGuiInputTextCallbackData* data) {
    auto& palette = *static_cast<Palette*>(data->UserData);
    palette.all_types = !palette.all_types;
    palette.first = palette.chosen = 0;
    return 0;
}

bool draw_query(State& state) {
    Palette& palette = state.palette;
    if (palette.opening) focus_field(state);
    const std::string filter = filter_of(palette);
    ImFont* small = state.fonts.regular(14);
    const float chip = filter.empty() ? 0 : text_width(small, 14, filter) + 20;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size(width_of(palette) - 2 * padding, query_tall);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, at + size, theme::field, 4);
    list.AddRect(at, at + size, theme::accent, 4, 0, 2);
    list.AddCircle(at + ImVec2(14, 14), 5, theme::text_dim, 0, 1.5F);
    list.AddLine(at + ImVec2(18, 18), at + ImVec2(21, 21), theme::text_dim, 1.5F);
    draw_text(list, small, 14, at + ImVec2(size.x - 10, 8),
              palette.all_types ? theme::text_off : theme::text_dim, filter, true);
    ImGui::SetCursorScreenPos(at + ImVec2(24, 0));
    ImGui::SetNextItemWidth(size.x - 24 - chip);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
    ImGui::PushStyleColor(ImGuiCol_Border, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(6, 7));
    const std::string before = palette.query;
    const bool enter = ImGui::InputTextWithHint(
        "##query", words_of(palette).hint, &palette.query,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackCompletion, on_query_tab,
        &palette);
    note_field(state);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor(2);
    ImGui::SetCursorScreenPos(at + ImVec2(0, query_tall + 4));
    if (palette.query != before) palette.first = palette.chosen = 0;
    return enter;
}

void draw_nothing(const State& state) {
    const Palette& palette = state.palette;
    const bool filtered = !filter_of(palette).empty() && !palette.all_types;
    const std::string text = std::string("No ") + words_of(palette).row + " matches \"" +
                             palette.query + "\". Backspace to widen" +
                             (filtered ? ", or Tab to search all types." : ".");
    write_paragraph(theme::text_dim, text, width_of(palette) - padding);
}

void draw_footer(const State& state) {
    const Palette& palette = state.palette;
    const ImVec2 at = ImGui::GetCursorScreenPos() + ImVec2(0, 2);
    const float width = width_of(palette) - 2 * padding;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine(at, at + ImVec2(width, 0), theme::border);
    const std::string words =
        std::string("\u2191\u2193 choose   Enter ") + words_of(palette).enter +
        (palette.wire.kind == Gesture::Kind::wire ? "   Tab all" : "") + "   Esc close";
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(4, 9), theme::text_dim, words);
    ImGui::Dummy({width, footer_tall - 4});
}

ImVec2 place_of(const Palette& palette) {
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float width = width_of(palette);
    const float tall = query_tall + footer_tall + 24 + row_tall(palette) * rows_shown;
    if (has_single_lines(palette)) return {std::max((room.x - width) / 2, 0.0F), 96};
    return {std::clamp(palette.at.x, 0.0F, std::max(room.x - width, 0.0F)),
            std::clamp(palette.at.y, 0.0F, std::max(room.y - tall, 0.0F))};
}

}  // namespace

void draw_palette(State& state) {
    Palette& palette = state.palette;
    if (!palette.open) return;
    const FixedWindow window("##palette", place_of(palette), {width_of(palette), 0},
                             {.padding = {padding, padding},
                              .ground = theme::node,
                              .border = theme::line,
                              .rounding = 8,
                              .opening = palette.opening});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    const bool enter = draw_query(state);
    const std::vector<PaletteRow> rows = palette_rows(state);
    move_choice(palette, static_cast<int>(rows.size()));
    int taken = draw_palette_rows(state, rows);
    if (rows.empty()) draw_nothing(state);
    draw_footer(state);
    ImGui::PopStyleVar();
    if (enter && !rows.empty()) taken = palette.chosen;
    if (!rows.empty() && ImGui::GetIO().KeyCtrl && ImGui::IsKeyPressed(key_named("D"), false))
        toggle_favorite(state, rows[static_cast<size_t>(palette.chosen)]);
    // ImGui unfocuses the field on Enter; focus it again if Enter had no effect.
    palette.opening = enter && (taken < 0 || !rows[static_cast<size_t>(taken)].off.empty());
    if (taken >= 0)
        choose(state, rows[static_cast<size_t>(taken)]);
    else if (window.has_lost_focus() || is_pressed(ImGuiKey_Escape))
        palette = {};
}

}  // namespace wrinkle::editor
