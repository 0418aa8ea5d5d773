// Values of the graph's inputs: the defaults, or those of a preset. In all functions `preset` is a
// preset of the graph; "" means the defaults.
#pragma once

#include <string>

#include "editor/model/document/model.h"

namespace wrinkle::editor {

// Returns true if the preset has a value for the input.
bool is_in_preset(const Document& document, const std::string& preset, std::string_view input);
// Returns the value of the preset; of an input that it does not name, the default.
json::Value value_of_input(const Document& document, const std::string& preset,
                           const GraphInput& input);
// Returns the numbers of that value; a choice, a count or a flag uses only the first. `port` is the
// input in Types.
std::array<double, 4> numbers_of_input(const Document& document, const std::string& preset,
                                       const GraphInput& input, const Port& port);

// Sets the value in the preset, or the default if `preset` is ""; a value equal to the default is
// removed from the preset.
Document with_input_value(const Document& document, const std::string& preset,
                          const std::string& input, json::Value value);
// Removes the input from the preset, so that it has its default.
Document without_input_value(const Document& document, const std::string& preset,
                             std::string_view input);

// Moves the input to the position of another one, and into its group.
Document with_input_at(const Document& document, std::string_view input, std::string_view target);
// Puts the input into the group, after the last input in it; in a new group it stays where it is.
Document with_input_in_group(const Document& document, std::string_view input,
                             const std::string& group);

// Adds a preset with the values of another one. `name` must be valid and free.
Document with_copied_preset(const Document& document, const std::string& name,
                            const std::string& from);
// Returns "preset 1", or with the next number that is free.
std::string free_preset_name(const Document& document);
// Returns the reason why a new preset cannot have that name, a sentence; "" if it can.
std::string preset_name_problem(const Document& document, const std::string& name);

struct PresetOfFile {
    Document document;  // with the preset, instead of another one of its name
    std::string name;
    std::string problem;  // a sentence; "": none
};
// Adds the preset of a file NAME.preset.json under NAME. It must be a preset of this graph, and all
// of its values must fit.
PresetOfFile with_preset_file(const Model& model, const Document& document,
                              const std::filesystem::path& file);

// Returns true if the condition of display of the input holds; without a condition it does.
bool is_displayed(const Model& model, const Document& document, const std::string& preset,
                  const GraphInput& input);

// Returns the port of an input of the document; nullptr if the model has none of that name.
const Port* port_of_input(const Model& model, std::string_view input);

// Returns the document with the preset's values as defaults.
Document with_preset_as_defaults(const Model& model, const Document& document,
                                 const std::string& preset);

// A document with the preset that is drawn.
struct PresetOf {
    const Document& document;
    const std::string& preset;
};
// Returns the names of the inputs with another value, in the order of `after`. Both documents have
// the same inputs, except for their defaults and presets (change.h).
std::vector<std::string> changed_inputs(const Model& model, const PresetOf& before,
                                        const PresetOf& after);

}  // namespace wrinkle::editor
