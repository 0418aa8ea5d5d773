// Presets: values of the top graph's inputs, in the graph under "presets" or in a file:
//
//   {"wrinkle_preset": 1, "graph": "painted_metal.json", "inputs": {"wear": 0.8}}
//
// "graph" and the paths of images are relative to the preset file. A color is an array of linear
// values or "#rrggbb", display-encoded. Inputs that a preset does not name are unchanged. An input
// may be called by a former name.
#pragma once

#include <filesystem>
#include <string>

#include "graph/subgraph.h"

namespace wrinkle {

inline constexpr std::string_view preset_suffix = ".preset.json";

// Returns the project with the preset's values as defaults of the inputs. `name` is a preset of the
// top graph, else a file that ends in ".json". Reports an error if there is neither, if the file is
// of another form or graph, and for inputs that do not exist; check() reports values that do not
// fit. Applying a preset twice is applying it once.
Project with_preset(const Project& project, const std::string& name, Diagnostics& diagnostics);

// Returns the preset in a file, named as the file, for the top graph: paths of images are relative
// to the graph. Reports the errors of files above; inputs that do not exist are left out.
Preset preset_of_file(const Project& project, const std::string& file, Diagnostics& diagnostics);

// Returns true for the name of a preset file rather than of a preset in the graph.
bool is_preset_file(const Project& project, const std::string& name);

}  // namespace wrinkle
