// Nodes as text on the system's clipboard: a whole, valid graph file of just these nodes, so that
// it can be pasted into another graph, another program or a mail.
//
// Wires from nodes that were not copied stand beside the text, in the State: they come back when
// the text is pasted into the document that it is from. What a text says is judged as a file is;
// one that is no graph, or too large, changes nothing.
#pragma once

#include <optional>
#include <string>

#include "editor/state.h"

namespace wrinkle::editor {

inline constexpr size_t most_pasted = 20'000;         // nodes
inline constexpr size_t longest_pasted = 32'000'000;  // bytes

// The nodes of a text, or why there are none.
std::optional<Document> nodes_from_text(const std::string& text, std::string& why);

void copy_selected(State& state);
void cut_selected(State& state);
void paste(State& state);  // at the pointer, or in the middle of the canvas

}  // namespace wrinkle::editor
