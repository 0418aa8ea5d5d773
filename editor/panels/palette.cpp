#include "editor/panels/palette.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "editor/canvas/layout.h"
#include "editor/commands/commands.h"
#include "editor/document/edits.h"
#include "editor/look/draw.h"
#include "editor/look/theme.h"

namespace wrinkle::editor {
namespace {

constexpr float width = 288, row_tall = 42;
constexpr size_t rows_shown = 8;

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

// Lower is better; negative: not found.
int rank(std::string_view name, std::string_view query) {
    const std::string text = lower_case(name);
    if (query.empty()) return 0;
    const size_t at = text.find(query);
    if (at == 0) return text.size() == query.size() ? 0 : 1;
    if (at != std::string::npos) return text[at - 1] == ' ' || text[at - 1] == '_' ? 2 : 3;
    size_t next = 0;
    for (const char c : text)
        if (next < query.size() && c == query[next]) ++next;
    return next == query.size() ? 4 : -1;
}

int best_rank(std::string_view title, std::string_view id, std::string_view query) {
    const int a = rank(title, query), b = rank(id, query);
    return a < 0 ? b : b < 0 ? a : std::min(a, b);
}

struct Row {
    std::string title, doc, key;
    std::string target;
    const NodeType* type = nullptr;
    const Command* command = nullptr;
};

std::vector<Row> node_rows(const State& state) {
    std::vector<Row> rows;
    for (const NodeType* type : search_nodes(state, state.palette.query))
        rows.push_back({type->title, type->doc, "", "palette:" + type->id, type, nullptr});
    return rows;
}

std::vector<Row> command_rows(const State& state) {
    std::vector<std::pair<int, Row>> found;
    for (const Command& command : commands()) {
        const int order = best_rank(command.title, command.id, lower_case(state.palette.query));
        if (order < 0 || !command.enabled(state)) continue;
        found.emplace_back(order, Row{std::string(command.title), std::string(command.menu),
                                      std::string(command.keys),
                                      "palette:" + std::string(command.id), nullptr, &command});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Row> rows;
    for (auto& [order, row] : found)
        rows.push_back(std::move(row));
    return rows;
}

void choose(State& state, const Row& row) {
    const Palette palette = state.palette;
    state.palette = {};
    if (row.command) return row.command->run(state);
    const ImVec2 at = to_canvas(state.view, palette.at);
    add_node_of_type(state, *row.type, at, palette.wire);
}

void draw_row(State& state, const Row& row, ImVec2 low, ImVec2 high, bool chosen) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (chosen) list.AddRectFilled(low, high, theme::accent_soft, 4);
    const Fonts& fonts = state.fonts;
    if (row.type)
        for (const Port& port : row.type->ports)
            if (port.kind == Port::Kind::output) {
                const ImVec2 at(low.x + 16, (low.y + high.y) / 2);
                draw_pin(list, port.type, at, 6, theme::of(port.type), true, theme::node);
                break;
            }
    draw_text(list, fonts.bold(16), 16, low + ImVec2(32, 4), theme::text, row.title);
    draw_text(list, fonts.regular(14), 14, low + ImVec2(32, 22), theme::text_dim,
              fitting(fonts.regular(14), 14, row.doc, width - 56));
    draw_text(list, fonts.regular(14), 14, ImVec2(high.x - 8, low.y + 5), theme::text_dim,
              chosen && row.key.empty() ? "Enter" : row.key, true);
}

void move_choice(State& state, size_t count) {
    const ImGuiIO& io = ImGui::GetIO();
    int& chosen = state.palette.chosen;
    if (ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_DownArrow])) ++chosen;
    if (ImGui::IsKeyPressed(io.KeyMap[ImGuiKey_UpArrow])) --chosen;
    chosen = std::clamp(chosen, 0, std::max(static_cast<int>(count) - 1, 0));
}

// The index of the row that was taken, -1 for none.
int draw_rows(State& state, const std::vector<Row>& rows) {
    int taken = -1;
    const int first = std::max(state.palette.chosen - static_cast<int>(rows_shown) + 1, 0);
    const int last = std::min(first + static_cast<int>(rows_shown), static_cast<int>(rows.size()));
    for (int i = first; i < last; ++i) {
        ImGui::PushID(i);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const ImVec2 high = low + ImVec2(width - 16, row_tall);
        if (ImGui::InvisibleButton("row", high - low)) taken = i;
        if (ImGui::IsItemHovered() && ImGui::GetIO().MouseDelta.x != 0) state.palette.chosen = i;
        const Row& row = rows[static_cast<size_t>(i)];
        draw_row(state, row, low, high, i == state.palette.chosen);
        state.targets.add(row.target, {low.x, low.y, high.x, high.y});
        ImGui::PopID();
    }
    return taken;
}

bool draw_query(State& state) {
    if (state.palette.opening) ImGui::SetKeyboardFocusHere();
    ImGui::PushStyleColor(ImGuiCol_Border, theme::accent);
    ImGui::SetNextItemWidth(-1);
    const std::string before = state.palette.query;
    const char* hint = state.palette.commands ? "Search commands" : "Search nodes";
    const bool enter = ImGui::InputTextWithHint("##query", hint, &state.palette.query,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
    ImGui::PopStyleColor();
    if (state.palette.query != before) state.palette.chosen = 0;
    return enter;
}

}  // namespace

std::vector<const NodeType*> search_nodes(const State& state, std::string_view query) {
    const std::string wanted = lower_case(query);
    std::vector<std::pair<int, const NodeType*>> found;
    for (const NodeType& type : state.registry->list()) {
        const int order = best_rank(type.title, type.id, wanted);
        if (order < 0 || !type_fits(type, state.palette.wire)) continue;
        const int converts = type_matches(type, state.palette.wire) ? 0 : 1;
        found.emplace_back(order * 2 + converts, &type);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const NodeType*> types;
    for (const auto& [order, type] : found)
        types.push_back(type);
    return types;
}

void draw_palette(State& state) {
    if (!state.palette.open) return;
    const ImVec2 room = ImGui::GetIO().DisplaySize;
    const float tall = 64 + (row_tall + 4) * rows_shown;
    ImGui::SetNextWindowPos({std::clamp(state.palette.at.x, 0.0F, std::max(room.x - width, 0.0F)),
                             std::clamp(state.palette.at.y, 0.0F, std::max(room.y - tall, 0.0F))});
    ImGui::SetNextWindowSize({width, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::node);
    ImGui::PushStyleColor(ImGuiCol_Border, theme::line);
    if (state.palette.opening) ImGui::SetNextWindowFocus();
    ImGui::Begin("##palette", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    const bool enter = draw_query(state);
    const auto rows = state.palette.commands ? command_rows(state) : node_rows(state);
    move_choice(state, rows.size());
    int taken = draw_rows(state, rows);
    if (rows.empty()) ImGui::TextDisabled("Nothing matches. Backspace to widen.");
    if (enter && !rows.empty()) taken = state.palette.chosen;
    const bool away =
        !ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows) && !state.palette.opening;
    ImGui::End();
    ImGui::PopStyleColor(2);
    ImGui::PopStyleVar(2);
    state.palette.opening = false;
    if (taken >= 0)
        choose(state, rows[static_cast<size_t>(taken)]);
    else if (away || ImGui::IsKeyPressed(ImGui::GetIO().KeyMap[ImGuiKey_Escape]))
        state.palette = {};
}

}  // namespace wrinkle::editor
