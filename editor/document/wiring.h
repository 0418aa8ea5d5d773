// Edits of the wires between nodes, as pure functions of a snapshot and of its types. None of them
// makes a wire between types that do not convert where there was none before.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/document/model.h"

namespace wrinkle::editor {

// A wire by both ends; node "" is the graph, whose inputs are its outputs.
struct Connection {
    Link from;
    std::string node;
    std::string port;
};

// The type that a place takes; nothing when it takes any, or when it is not known.
std::optional<PortType> wanted_at(const Model& model, const std::string& node,
                                  const std::string& port);
// Whether a wire of that type may end there; a reroute passes it on to all that it feeds.
bool wire_is_legal(const Model& model, const Document& document, PortType given,
                   const std::string& node, const std::string& port);
bool converts(PortType from, std::optional<PortType> to);

// What is fed by a reroute, through others too.
std::vector<Connection> fed_by_reroute(const Document& document, const std::string& id);

// The ports through which a wire can run through a node of that type: `given` fits `in`, and `out`
// fits `wanted`. Equal types first, then in the order of the ports.
struct Passage {
    std::string in, out;
};
std::optional<Passage> passage(const NodeType& type, PortType given,
                               std::optional<PortType> wanted);

// Without the nodes. A wire that one of them fed is fed by what the node passes on: its first
// connected input of the output's type, else its first connected one that converts to it.
Document delete_and_heal(const Model& model, const Document& document,
                         const std::set<std::string>& ids);
// Without the nodes and the wires at them.
Document delete_and_part(const Model& model, const Document& document,
                         const std::set<std::string>& ids);
// Without the wires into these nodes from others.
Document without_outer_wires(const Model& model, const Document& document,
                             const std::set<std::string>& ids);
// Without the wires.
Document cut_wires(const Model& model, const Document& document,
                   const std::vector<Connection>& wires);

// The node stands in the wire then.
Document insert_in_wire(const Document& document, const Connection& wire, const std::string& id,
                        const Passage& through);

// What stands at the inputs of the first type that the node takes twice moves on by one input; two
// inputs change places. The document itself when there are no two.
Document swap_inputs(const Model& model, const Document& document, const std::string& id);

// The nodes and all that they are made of, or all that is made of them.
std::set<std::string> with_upstream(const Document& document, const std::set<std::string>& ids);
std::set<std::string> with_downstream(const Document& document, const std::set<std::string>& ids);

// Nodes that no wire touches.
bool is_unconnected(const Document& document, const std::string& id);

}  // namespace wrinkle::editor
