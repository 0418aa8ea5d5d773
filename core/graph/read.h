// Text to Document, with every structural problem in one go.
//
// Checked: JSON itself (json/parse.h), "wrinkle": 1, the shapes of all known keys, ids and names,
// duplicates, link syntax, links to nodes and graph inputs that do not exist, surface names,
// cycles. The problems come in the order of the text. A partly wrong text gives a Document of what
// could be read. After a syntax error only what was read before it is judged: nothing counts as
// missing.
#pragma once

#include <string>

#include "graph/document.h"

namespace wrinkle {

struct ReadLimits {
    uint32_t depth = 64;         // nesting of arrays and objects
    uint32_t nodes = 1'000'000;  // of a graph with its sub-graphs
    uint32_t nodes_before = 0;   // in the files that were read before this one
    uint32_t ports = 256;        // inputs of a graph, and outputs: those of a node, as plugins have
};

Document read_document(std::string bytes, std::string file, Diagnostics& diagnostics,
                       ReadLimits limits = {});

// Errors for the keys that the format does not know. Reading and saving keep them; compiling asks.
// ("$schema" at the top is known and means nothing.)
void report_unknown(const Document& document, Diagnostics& diagnostics);

}  // namespace wrinkle
