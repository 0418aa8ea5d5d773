// What the material on the canvas costs, node by node: of the text that the preview runs, with its
// values as uniforms. A sub-graph's nodes count for the node that stands for it.
#pragma once

#include <string>
#include <vector>

#include "graph/document.h"
#include "ir/cost.h"

namespace wrinkle::editor {

struct Costs {
    Cost total;               // with what the outputs alone need
    std::vector<Cost> nodes;  // by index in the document
};

Costs count_costs(const Module& module, const Document& document);

// "1 read · 14 ops"; "14 ops" where nothing is read.
std::string in_words(const Cost& cost);

}  // namespace wrinkle::editor
