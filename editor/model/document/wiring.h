// Edits of the wires between nodes, as pure functions of a snapshot and its types. None of them
// adds a connection between types that do not convert.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/model/document/model.h"

namespace wrinkle::editor {

// A wire by both ends; node "" is the graph, which has its outputs as inputs.
struct Connection {
    Link from;
    std::string node;
    std::string port;
};

// Returns a node of that type with the id `id`, or another that is free.
Node new_node(const Document& document, std::string_view id, std::string_view type);

// Wires by their input end: an output of the graph counts as an input of node "".
std::optional<Link> link_at(const Document& document, const std::string& node,
                            const std::string& port);
Document with_wire(const Document& document, const Link& from, const std::string& node,
                   const std::string& port);
Document without_wire(const Document& document, const std::string& node, const std::string& port);

// Returns the type that an input takes; std::nullopt if it takes any or is not known.
std::optional<PortType> wanted_at(const Model& model, const std::string& node,
                                  const std::string& port);
// Returns true if a wire of that type may end there; a reroute must fit all its users.
bool wire_is_legal(const Model& model, const Document& document, PortType given,
                   const std::string& node, const std::string& port);
// Returns the reason why a wire from `from` may not end there; "" if it may.
std::string wire_problem(const Model& model, const Document& document, const Link& from,
                         const std::string& node, const std::string& port);
bool converts(PortType from, std::optional<PortType> to);
// Returns the types to which the value of a wire to this input must convert: that of the input, or
// those of all users of a reroute.
std::vector<PortType> wanted_ends(const Model& model, const Document& document,
                                  const std::string& node, const std::string& port);
bool converts(PortType from, const std::vector<PortType>& ends);

// Ports by which a node of that type can be inserted in a wire: `given` fits `in`, and `out` fits
// all of `ends`. Equal types first, then in port order. A bump is not resolved on its way: only a
// normal fits an input of type normal.
struct Passage {
    std::string in, out;
};
std::optional<Passage> passage(const NodeType& type, PortType given,
                               const std::vector<PortType>& ends);

// Removes the nodes and reconnects their users: each gets the source of the node's first connected
// input of the output's type, else of the first connected input that converts to it.
Document delete_and_reconnect(const Model& model, const Document& document,
                              const std::set<std::string>& ids);
// Removes the nodes and their wires.
Document delete_and_disconnect(const Model& model, const Document& document,
                               const std::set<std::string>& ids);
// Removes the wires from other nodes into these.
Document without_outer_wires(const Model& model, const Document& document,
                             const std::set<std::string>& ids);
// Removes the wires.
Document cut_wires(const Model& model, const Document& document,
                   const std::vector<Connection>& wires);

// Inserts the node in the wire.
Document insert_in_wire(const Document& document, const Connection& wire, const std::string& id,
                        const Passage& through);

// Swaps the first two inputs of the first type that the node has at least twice, preferring inputs
// with a value or a wire and ignoring inputs with a surface property as default. Returns the
// document unchanged if no type has two.
Document swap_inputs(const Model& model, const Document& document, const std::string& id);

// Returns true if no wire is connected to the node.
bool is_unconnected(const Document& document, const std::string& id);

// Visits all wires of a document, those to its outputs last: source, node and port.
template <class Visit>
void each_link(const Document& document, Visit visit) {
    for (const NodePtr& node : document.nodes)
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::link) visit(input.link, node->id, input.port);
    for (const Output& output : document.outputs)
        if (output.from.kind == Input::Kind::link) visit(output.from.link, "", output.name);
}
template <class Visit>
void each_wire(const Document& document, Visit visit) {
    each_link(document, [&](const Link& from, const std::string& node, const std::string& port) {
        visit(Connection{from, node, port});
    });
}

// Removes the wires into and from these nodes with types that do not convert: a reroute that lost
// its source carries a float.
Document without_invalid_links(const Document& document, const std::set<std::string>& ids,
                               const std::filesystem::path& folder, const Registry& registry);

}  // namespace wrinkle::editor
