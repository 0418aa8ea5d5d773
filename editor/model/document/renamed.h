// Names that inputs of graphs had before (graph/renamed.h), in the open graph.
#pragma once

#include <string>

#include "editor/model/session.h"

namespace wrinkle::editor {

// Returns the reason why the input cannot have that name, a sentence; "" if it can.
std::string input_name_problem(const Document& document, const std::string& input,
                               const std::string& name);

// Renames an input of the graph with everything that names it, in one step. The old name becomes a
// former one if the saved graph has it, so that presets and other graphs still find the input.
// `name` must have no problem.
void rename_input(Session& session, const std::string& input, const std::string& name);

// In each node that is an instance of a sub-graph, replaces former names of inputs by the current
// ones of the model, in all states of the history. Adds no step; the document stays unmodified.
void use_current_names(Session& session);

}  // namespace wrinkle::editor
