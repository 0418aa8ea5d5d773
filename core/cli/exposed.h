// The inputs that a graph declares and its presets, as `wrinkle inputs` lists them.
#pragma once

#include <string>

#include "lower/types.h"

namespace wrinkle::cli {

// Returns the members "exposed" and "presets" of a JSON object. Slider, limits, unit and doc of an
// input are its own or those of the port that it feeds. "built_in" marks inputs that are
// constants of the generated text.
std::string exposed_json(const Project& project, const Types& types);

// Returns one line per input, then one line per preset.
std::string exposed_text(const Project& project, const Types& types);

}  // namespace wrinkle::cli
