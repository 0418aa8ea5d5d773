// The type of every node of a project: from the registry, or generated:
//
//   graph:FILE   one type per file: the graph's inputs are its input ports, the graph's outputs its
//                output ports. An output with a standard name has that name's type, any other the
//                type of its source; an output of unknown type has no port.
//   reroute      input `in`, output `out`, both of the type of the connected source; float if the
//                input is not connected.
//
// These nodes have no type: a node of an unknown type or of a sub-graph that cannot be read, a
// reroute of an unknown source, reroutes in a cycle.
//
// Inputs of nodes are looked up by name once, for all later queries.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "registry/registry.h"

namespace wrinkle {

struct Link;
struct Node;
struct Output;
struct Project;

// Returns the files in topological order: each after its sub-graphs, the top graph last.
std::vector<uint32_t> files_in_order(const Project& project);

// Returns the names of the outputs, or of all other ports.
std::vector<std::string> port_names(const NodeType& type, bool outputs);

// Returns the kind of options that a graph input of this type goes to; std::nullopt for types on
// wires.
std::optional<Port::Kind> option_kind(std::string_view type);

// The source of a link to a node; none: no node or output has that name, or the link does not lead
// to a node.
struct LinkSource {
    static constexpr uint32_t none = NodeType::none;
    uint32_t node = none;    // in the document
    uint32_t output = none;  // in that node's type
};
// An entry of a node's "in".
struct NamedInput {
    uint32_t port = NodeType::none;  // in the node's type
    LinkSource source;
};

class Types {
public:
    Types(const Project& project, const Registry& registry);

    // Returns nullptr if the node has no type.
    const NodeType* of(size_t file, size_t node) const { return files_[file].nodes[node]; }
    // Returns all inputs of a node, in its order.
    std::span<const NamedInput> inputs(size_t file, size_t node) const {
        const File& in = files_[file];
        return std::span(in.inputs).subspan(in.first[node], in.first[node + 1] - in.first[node]);
    }
    LinkSource source(size_t file, const Link& link) const;
    // Returns the type that a link carries; std::nullopt if its source is unknown, missing or
    // is an input for options.
    std::optional<PortType> link(size_t file, const Link& link, LinkSource source) const;
    std::optional<PortType> link(size_t file, const Link& link) const {
        return this->link(file, link, source(file, link));
    }
    std::optional<PortType> output(size_t file, const Output& output) const;
    // Returns the type of a file's sub-graph nodes; its `origin` is the file's path.
    const NodeType& subgraph(size_t file) const { return graphs_[file]; }
    // Returns an input of a file's graph as a port of its sub-graph nodes. An input that feeds one
    // port has that port's choices, slider, limits, unit and doc unless it has others.
    const Port& graph_input(size_t file, size_t input) const { return graphs_[file].ports[input]; }

private:
    struct File {
        std::vector<const NodeType*> nodes;
        std::vector<NamedInput> inputs;  // inputs of all nodes
        std::vector<uint32_t> first;     // by node, and one more: index of its first input
    };
    void type_file(const Project& project, const Registry& registry, size_t file);
    void type_reroutes(size_t file);
    const NodeType* reroute(size_t file, const Node& node) const;
    void look_up_inputs(size_t file);
    void add_graph_inputs(size_t file);
    LinkSource source(size_t file, uint32_t node, std::string_view output) const;

    const Project* project_;
    std::vector<File> files_;
    std::vector<NodeType> graphs_;  // by file
};

}  // namespace wrinkle
