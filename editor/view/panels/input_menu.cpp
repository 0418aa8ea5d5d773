// Menu of a row of the panel of inputs: the value as text, and the declaration of the input.
#include <imgui.h>
#include <imgui_stdlib.h>

#include "editor/model/document/expose.h"
#include "editor/model/document/inputs.h"
#include "editor/model/document/renamed.h"
#include "editor/view/panels/input_row.h"
#include "editor/view/panels/panels.h"
#include "graph/edit.h"
#include "json/parse.h"
#include "json/write.h"
#include "lower/literal.h"

namespace wrinkle::editor {
namespace {

// Sets the value to the typed JSON, or to a word.
void type_value(State& state, const InputRow& row) {
    const std::string& text = state.inputs_panel.text;
    Diagnostics ignored;
    const json::Parsed parsed = json::parse(text, "value", ignored);
    const json::Value value =
        parsed.complete && !ignored.has_errors() ? parsed.root : json::Value::string(text);
    for (const LiteralProblem& problem : literal_problems(value, row.port)) {
        state.status = row.input.name + " " + problem.message + ". " + sentence(problem.expected);
        if (problem.severity == Severity::error) return;
    }
    state.inputs_panel.merge.clear();
    set_input(state, row, value);
    ImGui::CloseCurrentPopup();
}

void type_name(State& state, const InputRow& row) {
    const std::string name = state.inputs_panel.name;
    if (name != row.input.name) {
        state.status = input_name_problem(state.document(), row.input.name, name);
        if (!state.status.empty()) return;
        rename_input(state, row.input.name, name);
    }
    ImGui::CloseCurrentPopup();
}

// Returns true if the text was entered.
bool draw_menu_field(State& state, const char* title, std::string& text,
                     const std::string& target) {
    constexpr float title_wide = 60, field_wide = 200;
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", title);
    ImGui::SameLine(title_wide);
    ImGui::SetNextItemWidth(field_wide);
    ImGui::PushID(title);
    const bool entered = ImGui::InputText(
        "##text", &text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopID();
    note_field(state);
    name_item(state, target);
    return entered;
}

// A key of the input that is edited as text. `set` returns the reason why the text does not fit, a
// sentence, or "".
struct Detail {
    const char* title;
    const char* target;
    bool numbers_only;
    std::string (*text)(const GraphInput&);
    std::string (*set)(GraphInput&, const std::string& text);
};

template <std::string GraphInput::*Key>
std::string word_of(const GraphInput& input) {
    return input.*Key;
}
template <std::string GraphInput::*Key>
std::string set_word(GraphInput& input, const std::string& text) {
    input.*Key = text;
    return {};
}

// "0, 1" for [0, 1]
std::string range_text(const GraphInput& input) {
    const auto range = range_of(input.slider);
    if (!range) return {};
    const std::string list = json::one_line(input.slider);
    return list.substr(1, list.size() - 2);
}

std::string set_range(GraphInput& input, const std::string& text) {
    Diagnostics ignored;
    const json::Parsed parsed = json::parse("[" + text + "]", "range", ignored);
    const auto range = parsed.complete ? range_of(parsed.root) : std::nullopt;
    if (!text.empty() && (ignored.has_errors() || !range || !(range->least < range->most)))
        return "A range is two numbers, the lesser first: 0, 1";
    input.slider = text.empty() ? json::Value() : parsed.root;
    return {};
}

std::string step_text(const GraphInput& input) {
    return input.step.is(json::Kind::number) ? json::one_line(input.step) : "";
}

std::string set_step(GraphInput& input, const std::string& text) {
    Diagnostics ignored;
    const json::Parsed parsed = json::parse(text.empty() ? "null" : text, "step", ignored);
    const json::Value& step = parsed.root;
    if (!text.empty() &&
        (ignored.has_errors() || !step.is(json::Kind::number) || !(step.as_number() > 0)))
        return "A step is a number greater than 0.";
    input.step = text.empty() ? json::Value() : step;
    return {};
}

constexpr Detail details[] = {
    {"Label", ":in-label", false, word_of<&GraphInput::label>, set_word<&GraphInput::label>},
    {"Group", ":group", false, word_of<&GraphInput::group>, set_word<&GraphInput::group>},
    {"Range", ":range", true, range_text, set_range},
    {"Step", ":step", true, step_text, set_step},
    {"Unit", ":unit", true, word_of<&GraphInput::unit>, set_word<&GraphInput::unit>},
};

void type_detail(State& state, const InputRow& row, const Detail& detail, const std::string& text) {
    GraphInput changed = row.input;
    state.status = detail.set(changed, text);
    if (!state.status.empty()) return;
    const bool moves = changed.group != row.input.group;
    Document document = set_graph_input(state.document(), changed);
    if (moves) document = with_input_in_group(document, changed.name, changed.group);
    state.commit("Change input " + changed.name, std::move(document));
    ImGui::CloseCurrentPopup();
}

void draw_details(State& state, const InputRow& row) {
    const bool number =
        row.port.kind == Port::Kind::count ||
        (!row.port.is_option() && row.port.type != PortType::color_ && lanes_of(row.port.type) > 0);
    std::vector<std::string>& texts = state.inputs_panel.details;
    for (size_t i = 0; i < std::size(details) && i < texts.size(); ++i) {
        const Detail& detail = details[i];
        if (detail.numbers_only && !number) continue;
        if (draw_menu_field(state, detail.title, texts[i], row.target() + detail.target))
            type_detail(state, row, detail, texts[i]);
    }
}

void open_input_menu(State& state, const InputRow& row) {
    const json::Value value = value_of_input(state.document(), row.preset, row.input);
    InputsPanel& panel = state.inputs_panel;
    panel.text = value.is(json::Kind::null) ? "" : json::one_line(value);
    panel.name = row.input.name;
    panel.details.clear();
    for (const Detail& detail : details)
        panel.details.push_back(detail.text(row.input));
    ImGui::OpenPopup("##input-menu");
}

// Button that moves the input by one position, up or down.
void draw_shift(State& state, const InputRow& row, const char* title, const char* target, int by) {
    const Table<GraphInput>& inputs = state.document().inputs;
    const size_t to = inputs.index_of(row.input.name) + static_cast<size_t>(by);  // may wrap around
    const std::string name = row.input.name;
    ImGui::BeginDisabled(to >= inputs.size());
    if (button(state, title, row.target() + target) && to < inputs.size())
        state.commit("Move input " + name,
                     with_input_at(state.document(), name, std::string(inputs[to].name)));
    ImGui::EndDisabled();
}

}  // namespace

void draw_input_menu(State& state, const InputRow& row) {
    const std::string name = row.input.name;
    if (icon_button(state, "more", row.target() + ":more",
                    "Type the value, rename, group, range, position, remove"))
        open_input_menu(state, row);
    const PanelPopup popup("##input-menu");
    if (!popup) return;
    if (ImGui::IsWindowAppearing()) focus_field(state);
    if (draw_menu_field(state, "Value", state.inputs_panel.text, row.target() + ":text"))
        type_value(state, row);
    if (draw_menu_field(state, "Name", state.inputs_panel.name, row.target() + ":name"))
        type_name(state, row);
    draw_details(state, row);
    draw_shift(state, row, "Up", ":up", -1);
    ImGui::SameLine();
    draw_shift(state, row, "Down", ":down", 1);
    ImGui::SameLine();
    if (button(state, "Copy the name", row.target() + ":copy")) {
        ImGui::SetClipboardText(("input." + name).c_str());
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (button(state, "Remove", row.target() + ":remove")) {
        state.commit("Remove input " + name, without_input(state.model, state.document(), name));
        ImGui::CloseCurrentPopup();
    }
}

}  // namespace wrinkle::editor
