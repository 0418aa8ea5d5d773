// A part of a graph as a graph of its own, and a node in its place.
//
// What fed the nodes from outside are the inputs of the new graph, what was read of them its
// outputs; types and conversions stay where they were. The new file stands beside the document's.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "editor/state.h"

namespace wrinkle::editor {

struct Group {
    Document inner;
    Document outer;    // with the node in place of the others
    std::string node;  // its id
};

// Nothing, and why, when a wire's type is not known, or when a wire leaves the nodes and comes
// back to them.
std::optional<Group> make_group(const Model& model, const Document& document,
                                const std::set<std::string>& ids, const std::string& file,
                                std::string& why);

// Of the selected nodes, in one step; writes the file.
void group_selected(State& state);

// The nodes of the one selected sub-graph in its place, in one step; its file stays.
void ungroup_selected(State& state);

}  // namespace wrinkle::editor
