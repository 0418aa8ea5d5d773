// Moves part of a graph into a new sub-graph file, with one node in its place.
//
// Sources outside the nodes become the inputs of the new graph, outputs with users outside become
// its outputs; types and conversions stay the same. The new file is written next to the document's.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "editor/view/state.h"

namespace wrinkle::editor {

struct Group {
    Document inner;
    Document outer;    // with the sub-graph node instead of the others
    std::string node;  // id of that node
};

// Returns std::nullopt with the reason in `why` if the type of a wire is not known, or if a wire
// leaves the nodes and returns to them.
std::optional<Group> make_group(const Model& model, const Document& document,
                                const std::set<std::string>& ids, const std::string& file,
                                std::string& why);

// Groups the selected nodes in one undo step and writes the file.
void group_selected(State& state);

// Inlines the one selected sub-graph in one undo step; its file remains.
void ungroup_selected(State& state);

}  // namespace wrinkle::editor
