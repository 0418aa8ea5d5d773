// Between the document and the preview: what it runs, with which values, and what it says of it.
#pragma once

#include "editor/document/change.h"
#include "editor/state.h"

namespace wrinkle::editor {

// What the preview is wanted to show of the document now.
PreviewRequest wanted_request(const State& state);

// Image files are read again, for the picture and for those on cards.
void forget_images(State& state);

// After a build: the program changes only when more than names and values differ.
void run_newest(State& state);
// Sends the values that differ from what the preview shows; false when one of them is no uniform.
bool send_values(State& state);
// Ids of nodes that the request names, after a renaming.
void rename_in_request(State& state, const Document& before);

// The problems of the newest picture, the driver's at the nodes whose lines it refused.
void hear_preview(State& state);

// The output that holds the other normal of what runs; "" when nothing is compared.
std::string other_normal(const State& state);

// A driver's refusal as a problem of a node: the line that its words name first is looked up in the
// reflection; without one it stays as it is.
Diagnostic at_node(const Diagnostic& refusal, const Reflection& reflection,
                   const std::map<std::string, std::string>& copied);

}  // namespace wrinkle::editor
