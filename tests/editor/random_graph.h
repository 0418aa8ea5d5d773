// Random graphs with legal wires, and a count of invalid wires and links of any graph, independent
// of the editor's compatibility checks.
#pragma once

#include <random>
#include <string>

#include "editor/model/document/model.h"
#include "graph/document.h"

namespace wrinkle::editor {

// 4 to 15 nodes plus reroutes, positioned on a grid, with some outputs.
Document random_graph(std::mt19937& random);

// Number of wires between types that do not convert or that are unknown.
size_t bad_wires(const Document& document);
// Number of errors in links: cycles and links without a source.
size_t bad_links(const Document& document);

}  // namespace wrinkle::editor
