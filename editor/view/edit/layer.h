// Adds nodes and connects them: an image source, its bump as output, its bump added to another.
// Functions map Document -> Document; on failure they return std::nullopt with the reason.
#pragma once

#include <optional>
#include <string>

#include "editor/view/state.h"

namespace wrinkle::editor {

struct NewNode {
    Document document;
    std::string id;
};

// Adds a node with an id derived from `wish` ("weave" of "weave.png") if that is a valid id; its
// corner is at a free position near `at` (canvas units).
NewNode with_node(const State& state, const Document& document, const NodeType& type,
                  std::string_view wish, ImVec2 at);

// Adds a node that reads the image `file`, a path as written in the graph.
NewNode with_image_node(const State& state, const NodeType& type, const std::string& file,
                        ImVec2 at);

// Returns the image input `name`, or the first one for ""; nullptr if there is none.
const Port* image_port(const NodeType& type, std::string_view name = {});
// Returns the output with the most information about the bump: a height, else a gradient; nullptr
// if the type has neither.
const Port* bump_of(const NodeType& type);

// Adds a resolve node after the bump and connects it to the output `normal`.
Document with_bump_shown(const State& state, const Document& document, const Link& bump, ImVec2 at);

// Adds the bump to the one on a wire: at a free input of an addition at the wire's end, else with a
// new addition. A wire from a resolve is replaced by the wire into it.
std::optional<Document> with_bump_on_wire(const State& state, const Document& document,
                                          const Wire& wire, const Link& bump, ImVec2 at,
                                          std::string& why);

// Returns true if a bump of that type can be added to the one on a wire.
bool takes_bump(const State& state, const Wire& wire, PortType bump);

// Returns the wire into the resolve that this wire comes from; otherwise the wire itself.
Wire before_resolve(const State& state, const Document& document, const Wire& wire);

// Resets the border cards to their usual positions when an empty graph gets its first nodes.
void leave_empty_graph(CanvasState& canvas);

}  // namespace wrinkle::editor
