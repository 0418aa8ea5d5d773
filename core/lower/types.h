// The type of every node of a project: that of the registry, or one made for it.
//
//   graph:FILE   one type a file: the graph's inputs are its input ports, its outputs its outputs.
//                An output with a standard name has that name's type, another that of its source.
//   reroute      input `in`, output `out`, both of the type of whatever is connected.
//
// An unknown type, or a sub-graph that cannot be read, has none.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "graph/subgraph.h"
#include "registry/registry.h"
#include "registry/standard.h"

namespace wrinkle {

// Each file after those of its sub-graphs, the top graph last.
std::vector<uint32_t> files_in_order(const Project& project);

class Types {
public:
    Types(const Project& project, const Registry& registry);

    // nullptr: unknown.
    const NodeType* of(size_t file, size_t node) const { return nodes_[file][node]; }
    // The type that a link carries; nothing when its end is unknown or does not exist.
    std::optional<PortType> link(size_t file, const Link& link) const;
    std::optional<PortType> output(size_t file, const Output& output) const;
    // The files as one node each; their `origin` is the file's path.
    const NodeType& subgraph(size_t file) const { return graphs_[file]; }

private:
    void type_file(const Project& project, const Registry& registry, size_t file);
    void type_reroutes(size_t file);
    const NodeType* reroute(size_t file, const Node& node) const;

    const Project* project_;
    std::vector<std::vector<const NodeType*>> nodes_;  // by file and node
    std::vector<NodeType> graphs_;                     // by file
};

}  // namespace wrinkle
