// Copies nodes as text on the system clipboard: a complete, valid graph file of only these nodes
// that can be pasted into another graph, another program or a mail.
//
// Wires from nodes that were not copied are stored in the State, not in the text; they are restored
// when the text is pasted into its source document. The text is validated like a file; a text that
// is not a graph or is too large changes nothing.
#pragma once

#include <optional>
#include <string>

#include "editor/view/state.h"

namespace wrinkle::editor {

inline constexpr size_t max_pasted_nodes = 20'000;      // nodes
inline constexpr size_t max_pasted_bytes = 32'000'000;  // bytes

// Returns the nodes of a text; std::nullopt with the reason in `why` on failure.
std::optional<Document> nodes_from_text(const std::string& text, std::string& why);

void copy_selected(State& state);
void cut_selected(State& state);
void paste(State& state);  // at the pointer, or in the middle of the canvas

}  // namespace wrinkle::editor
