// Generated source, as written by `wrinkle compile`. Lines of the selected nodes are highlighted.
// The node of the line under the pointer is highlighted on the canvas; a click selects it.
#include <algorithm>

#include "base/text.h"
#include "editor/model/code/tokens.h"
#include "editor/model/document/change.h"
#include "editor/view/commands/commands.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/panels.h"
#include "editor/view/refresh.h"

namespace wrinkle::editor {
namespace {

constexpr float code_head = 38, line_height = 17, number_right = 32, text_left = 44;

// By Token; pointers, because the theme changes the colors.
const ImU32* const token_colors[] = {&theme::code_text,   &theme::code_keyword,
                                     &theme::code_type,   &theme::code_function,
                                     &theme::code_number, &theme::code_comment};

void draw_line(ImDrawList& list, ImFont* font, ImVec2 at, std::string_view line) {
    const float advance = font->GetCharAdvance('m') * font->Scale;
    for (const Piece& piece : pieces_of(line))
        list.AddText(font, font->FontSize * font->Scale,
                     {at.x + advance * static_cast<float>(piece.begin), at.y},
                     *token_colors[static_cast<size_t>(piece.token)], line.data() + piece.begin,
                     line.data() + piece.end);
}

void take(Code& code, CodeText text) {
    code.problem = text.problem;
    if (text.problem.empty()) code.text = std::move(text);
}

bool is_asked(const Session& session) {
    const Code& code = session.code;
    if (!code.requested || code.requested_file != session.follow.first) return false;
    if (code.requested_options != code.options) return false;
    if (same_document(code.requested_snapshot, session.document())) return true;
    const Change difference = change(code.requested_snapshot, session.document());
    return !difference.renamed &&
           (difference.kind == Change::Kind::none || difference.kind == Change::Kind::cosmetic);
}

// Takes finished source and requests it for a changed document, except while a value is dragged.
void follow(State& state) {
    Code& code = state.code;
    if (code.maker)
        if (auto text = code.maker->take()) take(code, std::move(*text));
    const bool other_file = code.requested_file != state.follow.first;
    if (!state.is_synced || is_asked(state)) return;
    if (!other_file && is_holding_value(state)) return;
    if (other_file) code.text = {};
    code.requested = true;
    code.requested_file = state.follow.first;
    code.requested_snapshot = state.document();
    code.requested_options = code.options;
    CodeJob job = job_of(state);
    if (code.maker)
        code.maker->post(std::move(job));
    else
        take(code, make_code(job));
}

// Offers the forms that the target has.
void draw_forms(State& state, float width) {
    CodeOptions& options = state.code.options;
    static const Item forms[] = {{"Function", "code:form:Function"},
                                 {"Vertex", "code:form:Vertex"},
                                 {"Fragment", "code:form:Fragment"}};
    const Forms possible = find_target(options.target)->forms;
    const bool function = form_of(options) == Form::function;
    const int form = function ? 0 : options.vertex ? 1 : 2;
    const size_t first = possible == Forms::shader ? 1 : 0;
    const size_t count = possible == Forms::function ? 1 : 3 - first;
    const int picked = choose(state, "code:form", forms[form].label,
                              std::span(forms).subspan(first, count), width);
    if (picked < 0) return;
    const int chosen = picked + static_cast<int>(first);
    options.form = chosen == 0 ? Form::function : Form::shader;
    options.vertex = chosen == 1;
}

void draw_options(State& state, float width) {
    CodeOptions& options = state.code.options;
    std::vector<Item> items;
    for (const Target& each : targets())
        items.push_back({std::string(each.label), "code:target:" + std::string(each.name)});
    const std::string shown(find_target(options.target)->label);
    const int target = choose(state, "code:target", shown, items, width);
    if (target >= 0) options.target = targets()[static_cast<size_t>(target)].name;
    ImGui::SameLine(0, 4);
    draw_forms(state, width);
    ImGui::SameLine(0, 4);
    static const Item values[] = {{"Baked", "code:parameters:Baked"},
                                  {"Uniforms", "code:parameters:Uniforms"}};
    const int picked =
        choose(state, "code:parameters", values[options.uniforms ? 1 : 0].label, values, width);
    if (picked >= 0) options.uniforms = picked == 1;
}

void draw_head(State& state) {
    const ImVec2 at = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, at + ImVec2(width, code_head), theme::panel);
    const float left = draw_side_titles(state);
    const std::string lines = counted(state.code.text.starts.size(), "line");
    ImFont* small = state.fonts.regular(14);
    draw_text(list, small, 14, at + ImVec2(left, 13), theme::text_dim, lines);
    constexpr float choice = 108, choices = 3 * choice + 8, buttons = 60, menu = 32;
    const float room = width - left - text_width(small, 14, lines) - 8;
    const bool wide = room >= choices + buttons + 12;
    ImGui::SetCursorPos({width - buttons - (wide ? choices : menu) - 12, 7});
    if (wide) {
        draw_options(state, choice);
    } else {
        if (icon_button(state, "more", "code:menu", "Language, form, parameters"))
            ImGui::OpenPopup("##code-options");
        if (const PanelPopup popup("##code-options"); popup) draw_options(state, choice);
    }
    ImGui::SetCursorPos({width - buttons - 4, 7});
    if (icon_button(state, "copy", "code:copy", "Copy the text"))
        ImGui::SetClipboardText(state.code.text.source.c_str());
    ImGui::SameLine(0, 4);
    if (icon_button(state, "export-glsl", "code:export", "Export GLSL...  Ctrl+E"))
        run_command(state, "export-glsl");
    ImGui::SetCursorPosY(code_head);
}

void draw_row(State& state, size_t index, float width) {
    const CodeText& text = state.code.text;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::string& node = text.node(index);
    const std::string number = std::to_string(index + 1);
    const auto [at, end, clicked, hovered] =
        area_button(state, "line:" + number, {width, line_height});
    if (!node.empty() && state.view.selected.contains(node)) {
        list.AddRectFilled(at, end, theme::code_highlight);
        list.AddRectFilled(at, at + ImVec2(3, line_height), theme::accent);
    }
    if (hovered) list.AddRect(at, end, theme::border);
    if (hovered) state.code.hovered = node;
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(number_right, 1), theme::text_off,
              number, true);
    draw_line(list, state.fonts.code(), at + ImVec2(text_left, 0), text.line(index));
    if (!clicked || !state.document().find(node)) return;
    state.view.selected = {node};
    state.code.scrolled_to = node;
}

// Scrolls to the lines of a node that was selected in another panel.
void scroll_to_selected(State& state) {
    Code& code = state.code;
    const std::string selected =
        state.view.selected.size() == 1 ? *state.view.selected.begin() : std::string();
    if (selected == code.scrolled_to) return;
    code.scrolled_to = selected;
    const auto found = std::ranges::find(code.text.nodes, selected);
    if (selected.empty() || found == code.text.nodes.end()) return;
    const float y = static_cast<float>(found - code.text.nodes.begin()) * line_height;
    const float top = ImGui::GetScrollY(), tall = ImGui::GetWindowHeight();
    if (y < top || y > top + tall - 3 * line_height) ImGui::SetScrollY(y - tall / 3);
}

// One-line message above the source.
void draw_message(const Fonts& fonts, ImU32 color, const std::string& text) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 end = at + ImVec2(width, strip_tall);
    const bool whole = draw_strip(fonts, at, width, theme::bar, color, text);
    if (!whole && ImGui::IsMouseHoveringRect(at, end)) show_tooltip({at, end}, text);
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + strip_tall);
}

}  // namespace

void draw_code(State& state) {
    follow(state);
    state.code.hovered.clear();
    draw_head(state);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::code);
    const CodeText& text = state.code.text;
    const std::string& problem = state.code.problem;
    const std::string why = why_no_line(state, state.view.selected);
    if (!problem.empty()) {
        const bool none = text.starts.empty();
        if (!none || !holds_nothing(state.document()))
            draw_message(state.fonts, theme::warn,
                         (none ? "No text yet. " : "The last text that could be made. ") +
                             sentence(problem));
    } else if (!why.empty()) {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        draw_message(state.fonts, theme::accent, why);
        name_area(state, "code:why", at, at + ImVec2(28, 28));
    }
    ImGui::BeginChild("##lines", {0, 0}, false,
                      ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_HorizontalScrollbar);
    const float advance = state.fonts.code()->GetCharAdvance('m');
    const float width = std::max(ImGui::GetContentRegionAvail().x,
                                 text_left + 8 + advance * static_cast<float>(text.longest));
    scroll_to_selected(state);
    draw_rows(text.starts.size(), line_height, [&](size_t line) { draw_row(state, line, width); });
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace wrinkle::editor
