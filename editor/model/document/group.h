// Moves part of a graph into a new sub-graph, with one node in its place.
//
// Sources outside the nodes become the inputs of the new graph, outputs with users outside become
// its outputs; types and conversions stay the same.
#pragma once

#include <optional>
#include <set>
#include <string>

#include "editor/model/document/model.h"

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

}  // namespace wrinkle::editor
