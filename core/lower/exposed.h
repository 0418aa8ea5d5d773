// Inputs and presets of the top graph for programs that show them, as JSON. `port` is the input in
// Types: slider, limits, unit, choices and doc of an input that feeds one port can be those of that
// port.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle {

// Returns the default of the input; "" if it has none.
std::string exposed_default(const GraphInput& input, const Port& port);

// Returns an object with the keys of the graph (docs/graph-format.md), `name`, and `built_in`: true
// if the input is a compile-time constant. `uniform` is the name in a shader; "": no key.
std::string exposed_input(const GraphInput& input, const Port& port,
                          const std::string& uniform = {});

// Returns the values of a preset by name of the input.
std::vector<std::pair<std::string, std::string>> preset_values(const Preset& preset);

}  // namespace wrinkle
