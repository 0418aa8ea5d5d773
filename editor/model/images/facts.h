// Description of an image as text: one line, and a table of the measured values.
#pragma once

#include <string>
#include <vector>

#include "editor/model/images/images.h"

namespace wrinkle::editor {

// "tangent-space normal map, green up: curl +0.87"
std::string summary_of(const Examined& examined);
// "The curl test gives +0.87: green points up at +1, down at -1"
std::string curl_words(const maps::Verdict& verdict);

struct Fact {
    std::string name, value;  // "Mean normal", "leans by 0.03°"
};
std::vector<Fact> facts_of(const Examined& examined);

}  // namespace wrinkle::editor
