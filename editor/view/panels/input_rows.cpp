// Rows of the panel of inputs: label, control, reset, menu.
#include <algorithm>
#include <cmath>

#include "base/srgb.h"
#include "editor/model/document/field.h"
#include "editor/model/document/inputs.h"
#include "editor/view/drop/drop.h"
#include "editor/view/look/draw.h"
#include "editor/view/look/theme.h"
#include "editor/view/look/tooltip.h"
#include "editor/view/panels/input_row.h"
#include "editor/view/panels/panels.h"
#include "lower/literal.h"

namespace wrinkle::editor {
namespace {

constexpr float input_row_tall = 30, row_icons = 56;

void begin_step(State& state, const InputRow& row) {
    state.inputs_panel.merge =
        "input " + row.input.name + " " + std::to_string(state.history.serial());
}

float to_step(const InputRow& row, float value) {
    if (row.port.kind == Port::Kind::count) return std::round(value);
    if (!row.input.step.is(json::Kind::number)) return value;
    const double step = row.input.step.as_number();
    return static_cast<float>(std::round(static_cast<double>(value) / step) * step);
}

float hard_clamped(const Port& port, float value) {
    if (!port.has_hard_range()) return value;
    return static_cast<float>(std::clamp(static_cast<double>(value), port.hard_min, port.hard_max));
}

json::Value number_literal(const InputRow& row, std::span<float> values) {
    std::vector<json::Value> items;
    for (const float value : values)
        items.push_back(json::Value::single(hard_clamped(row.port, to_step(row, value))));
    return items.size() == 1 ? items[0] : json::Value::array(items);
}

// Returns the slider of the input, or its limits without one; std::nullopt if they are infinite.
std::optional<Range> control_range(const Port& port) {
    const Range range = port.has_soft_range() ? Range{port.soft_min, port.soft_max}
                                              : Range{port.hard_min, port.hard_max};
    const double wide = range.most - range.least;
    return wide > 0 && std::isfinite(wide) ? std::optional(range) : std::nullopt;
}

// Fills the part of a slider below its value, as fields of cards are filled; ImGui draws the text.
void draw_filled_part(double value, const Range& range, float width) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const ImVec2 high = low + ImVec2(width, ImGui::GetFrameHeight());
    const double part = std::clamp((value - range.least) / (range.most - range.least), 0.0, 1.0);
    const float x = low.x + width * static_cast<float>(part);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, theme::field, 4);
    if (x - low.x < 2) return;
    list.AddRectFilled(low, {x, high.y}, theme::accent_soft, 4);
    list.AddRectFilled({low.x + 3, high.y - 2}, {x, high.y}, theme::accent);
}

// Format of ImGui for a number with the unit of the port.
std::string number_format(const Port& port) {
    std::string format = port.unit.empty() ? "%.4g" : "%.4g ";
    for (const char c : port.unit == "x" ? "\u00D7" : port.unit)
        format += c == '%' ? std::string("%%") : std::string(1, c);
    return format;
}

// Slider over the range; one of a single number is filled. Returns true if it changed the values.
bool draw_slider(std::span<float> values, const Range& range, const char* format, float width) {
    const auto low = static_cast<float>(range.least), high = static_cast<float>(range.most);
    const bool filled = values.size() == 1;
    if (filled) draw_filled_part(static_cast<double>(values[0]), range, width);
    for (const ImGuiCol each : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
                                ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive})
        ImGui::PushStyleColor(each, filled ? 0 : ImGui::GetColorU32(each));
    const bool changed = ImGui::SliderScalarN("##value", ImGuiDataType_Float, values.data(),
                                              static_cast<int>(values.size()), &low, &high, format,
                                              ImGuiSliderFlags_NoInput);
    ImGui::PopStyleColor(5);
    return changed;
}

void draw_number(State& state, const InputRow& row, float width) {
    float numbers[4];
    std::ranges::transform(row.numbers, numbers, [](double n) { return static_cast<float>(n); });
    const int lanes = row.port.kind == Port::Kind::count ? 1 : lanes_of(row.port.type);
    const std::span<float> values(numbers, static_cast<size_t>(lanes));
    const std::string format = number_format(row.port);
    const float speed = std::max(std::fabs(numbers[0]), 0.1F) / 100;
    const auto range = control_range(row.port);
    const bool changed =
        range ? draw_slider(values, *range, format.c_str(), width)
              : ImGui::DragScalarN("##value", ImGuiDataType_Float, numbers,
                                   static_cast<int>(values.size()), speed, nullptr, nullptr,
                                   format.c_str(), ImGuiSliderFlags_NoInput);
    name_item(state, row.target());
    note_held(state);
    if (ImGui::IsItemActivated()) begin_step(state, row);
    if (changed) set_input(state, row, number_literal(row, values));
}

void draw_input_color(State& state, const InputRow& row, float width) {
    std::array<float, 3> color, shown;
    std::transform(row.numbers.begin(), row.numbers.begin() + 3, color.begin(),
                   [](double linear) { return static_cast<float>(linear); });
    std::transform(row.numbers.begin(), row.numbers.begin() + 3, shown.begin(),
                   [](double linear) { return static_cast<float>(srgb_from_linear(linear)); });
    if (ImGui::ColorButton("##value", {shown[0], shown[1], shown[2], 1},
                           ImGuiColorEditFlags_Float | ImGuiColorEditFlags_HDR |
                               ImGuiColorEditFlags_NoAlpha | ImGuiColorEditFlags_NoTooltip,
                           {width, ImGui::GetFrameHeight()})) {
        begin_step(state, row);
        ImGui::OpenPopup("##picker");
    }
    name_item(state, row.target());
    const PanelPopup popup("##picker");
    if (!popup) return;
    if (popup.is_left()) return state.history.cancel(state.inputs_panel.merge);
    const bool changed = pick_color(state, row.target() + ":picker", color);
    if (changed) set_input(state, row, number_literal(row, color));
}

void draw_flag(State& state, const InputRow& row) {
    bool on = row.numbers[0] != 0;
    if (ImGui::Checkbox("##value", &on)) {
        state.inputs_panel.merge.clear();
        set_input(state, row, json::Value::boolean(on));
    }
    name_item(state, row.target());
}

// A list of words, of which one is the value: names of a choice or files of images.
void draw_words(State& state, const InputRow& row, const std::string& shown,
                const std::vector<std::string>& words, float width) {
    std::vector<Item> items;
    for (const std::string& word : words)
        items.push_back({word, row.target() + ":" + word});
    const int picked = choose(state, row.target(), shown, items, width);
    if (picked < 0) return;
    state.inputs_panel.merge.clear();
    const json::Value old = value_of_input(state.document(), row.preset, row.input);
    const std::string& word = words[static_cast<size_t>(picked)];
    set_input(state, row, row.port.is_option() ? json::Value::string(word) : with_file(old, word));
}

void draw_input_control(State& state, const InputRow& row, float width) {
    const Port& port = row.port;
    ImGui::SetNextItemWidth(width);
    if (port.kind == Port::Kind::flag) return draw_flag(state, row);
    if (port.kind == Port::Kind::count) return draw_number(state, row, width);
    if (port.kind == Port::Kind::choice) {
        const auto index = static_cast<size_t>(row.numbers[0]);
        const std::string shown = index < port.choices.size() ? port.choices[index] : "?";
        return draw_words(state, row, shown, port.choices, width);
    }
    if (port.type == PortType::image_) {
        const json::Value value = value_of_input(state.document(), row.preset, row.input);
        const std::string file(literal_image(value).file);
        return draw_words(state, row, file.empty() ? "choose..." : file,
                          image_files(state.folder()), width);
    }
    if (port.type == PortType::color_) return draw_input_color(state, row, width);
    if (lanes_of(port.type) > 0) return draw_number(state, row, width);
    ImGui::TextDisabled("%s", std::string(name_of(port.type)).c_str());
}

// Moves the row by a drag of its label: a line marks the row that it takes the position of, where
// the button is released. Escape ends the drag.
void carry_row(State& state, const InputRow& row, ImVec2 at, float wide) {
    InputsPanel& panel = state.inputs_panel;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left) && !panel.carry_left)
        panel.carried = row.input.name;
    if (panel.carried.empty() || mouse.y < at.y || mouse.y >= at.y + input_row_tall) return;
    panel.carried_to = row.input.name;
    const bool down = state.document().inputs.index_of(panel.carried) <
                      state.document().inputs.index_of(row.input.name);
    const float y = down ? at.y + input_row_tall - 3 : at.y - 3;
    if (panel.carried != row.input.name)
        ImGui::GetWindowDrawList()->AddRectFilled({at.x, y}, {at.x + wide, y + 2}, theme::accent);
}

void drop_row(State& state) {
    InputsPanel& panel = state.inputs_panel;
    const bool down = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (!down) panel.carry_left = false;
    if (panel.carried.empty()) return;
    panel.carry_left = is_pressed(ImGuiKey_Escape, false);
    if (down && !panel.carry_left) return;
    const std::string input = std::exchange(panel.carried, {});
    const std::string to = std::exchange(panel.carried_to, {});
    if (!panel.carry_left)
        state.commit("Move input " + input, with_input_at(state.document(), input, to));
}

void draw_input_row(State& state, const InputRow& row) {
    const float wide = ImGui::GetContentRegionAvail().x, label_wide = std::floor(wide * 0.36F);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const std::string& label = row.input.label.empty() ? row.input.name : row.input.label;
    press_area("##label", {label_wide, ImGui::GetFrameHeight()});
    name_item(state, row.target() + ":label");
    const bool hovered = ImGui::IsItemHovered();
    carry_row(state, row, at, wide);
    ImFont* font = state.fonts.regular(16);
    draw_text(*ImGui::GetWindowDrawList(), font, 16, at + ImVec2(0, 4), theme::text,
              fitting(font, 16, label, label_wide - 8));
    if (hovered && state.inputs_panel.carried.empty())
        show_tooltip(last_item(), state.fonts.bold(16), "input." + row.input.name, row.port.doc);
    ImGui::SameLine(0, 0);
    const std::string name = row.input.name;
    const bool in_preset = is_in_preset(state.document(), row.preset, name);
    draw_input_control(state, row, wide - label_wide - row_icons - 4);
    ImGui::SetCursorScreenPos(at + ImVec2(wide - row_icons, 0));
    if (in_preset) {
        if (icon_button(state, "undo", row.target() + ":reset", "Back to the default"))
            state.commit("Reset " + name, without_input_value(state.document(), row.preset, name));
    }
    ImGui::SetCursorScreenPos(at + ImVec2(wide - row_icons / 2, 0));
    draw_input_menu(state, row);
    ImGui::SetCursorScreenPos(at + ImVec2(0, input_row_tall));
}

}  // namespace

void set_input(State& state, const InputRow& row, json::Value value) {
    state.commit("Set " + row.input.name,
                 with_input_value(state.document(), row.preset, row.input.name, std::move(value)),
                 state.inputs_panel.merge);
}

void draw_input_rows(State& state) {
    const Document document = state.document();  // a row may change it and its types
    const std::shared_ptr<const Types> types = state.model.types;
    const std::string preset = state.view.preview_request.preset;
    std::string group;
    bool first = true;
    for (const GraphInput& input : document.inputs) {
        const Port* port = port_of_input(state.model, input.name);
        if (!port || !is_displayed(state.model, document, preset, input)) continue;
        if (input.group != group) {
            group = input.group;
            if (!first) ImGui::Dummy({0, 6});
            if (!group.empty()) ImGui::TextDisabled("%s", group.c_str());
        }
        first = false;
        ImGui::PushID(input.name.c_str());
        draw_input_row(state,
                       {input, *port, preset, numbers_of_input(document, preset, input, *port)});
        ImGui::PopID();
    }
    drop_row(state);
}

}  // namespace wrinkle::editor
