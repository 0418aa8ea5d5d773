// Graphs of random nodes and legal wires, and what is wrong with the wires of any graph, found
// without the editor's own idea of what fits.
#pragma once

#include <random>
#include <string>

#include "editor/document/model.h"
#include "graph/document.h"

namespace wrinkle::editor {

// 4 to 24 nodes with places on a grid, some reroutes among them, some outputs.
Document random_graph(std::mt19937& random);

// The wires between types that do not convert, or whose type is not known.
size_t bad_wires(const Document& document);
// Loops and links that lead nowhere.
size_t bad_links(const Document& document);

}  // namespace wrinkle::editor
