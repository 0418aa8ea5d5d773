// Parser of graph files: text to Document, reporting all structural problems in one pass.
//
// Checked: JSON itself (json/parse.h), "wrinkle": 1, the shapes of all known keys, ids and names,
// duplicates, link syntax, links to missing nodes and graph inputs, cycles. Problems are reported
// in text order. Invalid text gives a Document of the parts that could be read. After a syntax
// error only the text before it is checked: missing keys are not reported.
#pragma once

#include <string>

#include "graph/document.h"

namespace wrinkle {

struct ReadLimits {
    uint32_t nodes = 1'000'000;  // nodes of a graph with its sub-graphs
    uint32_t nodes_before = 0;   // nodes of the files that were read before this one
    uint32_t ports = 256;        // inputs of a graph, and outputs; same limit as for a plugin node
    uint32_t presets = 1000;
};

Document read_document(std::string bytes, std::string file, Diagnostics& diagnostics,
                       ReadLimits limits = {});

// Reports an error for each key that the format does not define. Reading and saving preserve such
// keys; compiling calls this. ("$schema" at the top is allowed and ignored.)
void report_unknown(const Document& document, Diagnostics& diagnostics);

}  // namespace wrinkle
