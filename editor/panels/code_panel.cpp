// The generated text: what `wrinkle compile` writes (baked), or what the preview runs (uniforms).
// Lines of the selected nodes are marked; a click on a line selects its node.
#include <cctype>

#include "editor/look/draw.h"
#include "editor/look/theme.h"
#include "editor/panels/panels.h"

namespace wrinkle::editor {
namespace {

constexpr float line_height = 17;

bool is_type(std::string_view word) {
    constexpr std::string_view types[] = {"void", "float", "int",  "uint", "bool",     "vec2",
                                          "vec3", "vec4",  "mat2", "mat3", "sampler2D"};
    for (const std::string_view type : types)
        if (word == type) return true;
    return word.starts_with("WrinkleSurface");
}

bool is_keyword(std::string_view word) {
    constexpr std::string_view words[] = {"struct", "uniform", "return", "for",  "if",   "else",
                                          "const",  "in",      "out",    "true", "false"};
    for (const std::string_view keyword : words)
        if (word == keyword) return true;
    return false;
}

bool is_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

ImU32 color_of(std::string_view line, size_t begin, size_t end) {
    const std::string_view word = line.substr(begin, end - begin);
    if (std::isdigit(static_cast<unsigned char>(word[0]))) return theme::code_number;
    if (is_keyword(word)) return theme::code_keyword;
    if (is_type(word)) return theme::code_type;
    if (end < line.size() && line[end] == '(') return theme::code_function;
    return theme::code_text;
}

void draw_line(ImDrawList& list, ImFont* font, ImVec2 at, std::string_view line) {
    const float advance = font->GetCharAdvance('m');
    const auto put = [&](size_t begin, size_t end, ImU32 color) {
        const ImVec2 place(at.x + advance * static_cast<float>(begin), at.y);
        list.AddText(font, font->FontSize, place, color, line.data() + begin, line.data() + end);
    };
    for (size_t i = 0; i < line.size();) {
        if (line.substr(i).starts_with("//")) return put(i, line.size(), theme::code_comment);
        size_t end = i + 1;
        if (is_word(line[i])) {
            while (end < line.size() &&
                   (is_word(line[end]) ||
                    (line[end] == '.' && std::isdigit(static_cast<unsigned char>(line[i])))))
                ++end;
            put(i, end, color_of(line, i, end));
        } else {
            while (end < line.size() && !is_word(line[end]) && line[end] != '/')
                ++end;
            put(i, end, theme::code_text);
        }
        i = end;
    }
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const size_t end = std::min(text.find('\n'), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

struct Text {
    const Shader* shader = nullptr;
    const std::vector<std::string>* nodes = nullptr;

    // The node that a line came from, "" for none.
    std::string node(size_t line) const {
        if (line >= shader->reflection.lines.size()) return {};
        const uint32_t index = shader->reflection.lines[line];
        return index < nodes->size() ? (*nodes)[index] : std::string();
    }
};

Text text_of(const State& state) {
    const Build& built = state.built;
    if (state.view.code_baked) return {built.baked ? &*built.baked : nullptr, &built.baked_nodes};
    return {built.uniform ? &*built.uniform : nullptr, &built.uniform_nodes};
}

void draw_head(State& state, size_t lines) {
    const ImVec2 at = ImGui::GetWindowPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, at + ImVec2(ImGui::GetWindowWidth(), 36), theme::panel);
    draw_text(list, state.fonts.bold(18), 17, at + ImVec2(12, 9), theme::text, "Code");
    draw_text(list, state.fonts.regular(14), 14, at + ImVec2(64, 11), theme::text_dim,
              std::to_string(lines) + " lines");
    ImGui::SetCursorPos({ImGui::GetWindowWidth() - 240, 6});
    if (button(state, "Uniforms", "code:uniforms", !state.view.code_baked))
        state.view.code_baked = false;
    ImGui::SameLine(0, 4);
    if (button(state, "Baked", "code:baked", state.view.code_baked)) state.view.code_baked = true;
    ImGui::SameLine(0, 12);
    const Text text = text_of(state);
    if (button(state, "Copy", "code:copy") && text.shader)
        ImGui::SetClipboardText(text.shader->source.c_str());
    ImGui::SetCursorPosY(40);
}

void draw_row(State& state, const Text& text, size_t index, std::string_view line) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string node = text.node(index);
    ImGui::PushID(static_cast<int>(index));
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0F), line_height);
    const bool clicked = ImGui::InvisibleButton("line", size);
    ImGui::PopID();
    if (!node.empty() && state.view.selected.contains(node)) {
        list.AddRectFilled(at, at + size, theme::code_highlight);
        list.AddRectFilled(at, at + ImVec2(3, line_height), theme::accent);
    } else if (ImGui::IsItemHovered()) {
        list.AddRect(at, at + size, theme::border);
    }
    state.targets.add("line:" + std::to_string(index + 1),
                      {at.x, at.y, at.x + size.x, at.y + size.y});
    draw_text(list, state.fonts.regular(14), 13, at + ImVec2(32, 2), theme::text_off,
              std::to_string(index + 1), true);
    draw_line(list, state.fonts.code(), at + ImVec2(44, 1), line);
    if (clicked && state.document().find(node)) state.view.selected = {node};
}

}  // namespace

void draw_code(State& state) {
    state.follow.code_shown = true;
    const Text text = text_of(state);
    const auto lines =
        text.shader ? lines_of(text.shader->source) : std::vector<std::string_view>();
    draw_head(state, lines.size());
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::code);
    ImGui::BeginChild("##lines", {0, 0}, false, ImGuiWindowFlags_NoNavInputs);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(lines.size()), line_height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_row(state, text, static_cast<size_t>(i), lines[static_cast<size_t>(i)]);
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

}  // namespace wrinkle::editor
