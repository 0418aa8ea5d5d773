// One row of the panel of inputs, and its menu.
#pragma once

#include <array>
#include <string>

#include "editor/view/state.h"

namespace wrinkle::editor {

// One input with its value in the chosen preset.
struct InputRow {
    const GraphInput& input;
    const Port& port;
    const std::string& preset;
    std::array<double, 4> numbers;

    std::string target() const { return "input:" + input.name; }
};

void set_input(State& state, const InputRow& row, json::Value value);

// Button and popup: typed value, name, label, group, range, step and unit, position, removal.
void draw_input_menu(State& state, const InputRow& row);

}  // namespace wrinkle::editor
