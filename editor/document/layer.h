// New nodes wired to what is there: a picture as a source, its bump shown, its bump laid over
// another. Document -> Document; an edit that cannot be made returns nothing and says why.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "editor/state.h"

namespace wrinkle::editor {

struct NewNode {
    Document document;
    std::string id;
};

// A node of the type, its id after `wish` ("weave" of "weave.png") where that can be an id, its
// corner at the free place nearest below `at` (canvas units).
NewNode with_node(const State& state, const Document& document, const NodeType& type,
                  std::string_view wish, ImVec2 at);

// A node that reads the picture `file`, a path as the graph writes it.
NewNode with_picture(const State& state, const NodeType& type, const std::string& file, ImVec2 at);

// The output of a type that tells most about its bump; nullptr for one that has none.
const Port* bump_of(const NodeType& type);

// A resolve behind the bump, and the output `normal` behind that.
Document with_bump_shown(const State& state, const Document& document, const Link& bump, ImVec2 at);

// The bump laid over the one on a wire: into a free input of an addition that the wire leads to,
// else through a new one. A wire that comes from a resolve stands for the one into it.
std::optional<Document> with_bump_on_wire(const State& state, const Document& document,
                                          const Wire& wire, const Link& bump, ImVec2 at,
                                          std::string& why);

// The wire into the resolve that this one comes out of, else itself.
Wire before_resolve(const State& state, const Document& document, const Wire& wire);

// Moves the cards at the borders where they belong once an empty graph has its first nodes.
void leave_empty_graph(State& state);

}  // namespace wrinkle::editor
