// Checks a project against the node types and reports every problem: all nodes of all its files,
// including those that no output needs.
//
// Reading (graph/read.h, graph/subgraph.h) has reported shapes, links to nodes that do not exist
// and cycles; this reports unknown types, ports and keys, literals that do not fit their port,
// values outside a hard range (a warning: they are clamped), images that are missing or outside the
// root, required inputs, links to outputs that do not exist, wires that do not convert, versions.
// No pixel is read.
#pragma once

#include "lower/types.h"

namespace wrinkle {

struct Document;
struct GraphInput;
template <class T>
class Table;
class NamedFiles;

struct CheckOptions {
    bool reachable_only = false;  // only nodes that the top graph's outputs need (live preview)
    NamedFiles* files = nullptr;  // known files of the project; null: none yet
};

void check(const Project& project, const Registry& registry, const Types& types,
           Diagnostics& diagnostics, const CheckOptions& options = {});

// A warning at a node with a map that is read on a projection along a plane (planar_uv, plane_uv,
// box_uv) while its port `scale` has no written value and the default `unit`: its slopes are then
// those of a map on a separate surface, not the volume's bump that the triplanar nodes make of the
// same image (docs/surface-gradient.md, Projections). Writing either value at the port removes the
// warning. Uvs are followed through nodes of the family "uv". Part of check().
void warn_of_projection(const Document& document, const Node& node, const NodeType& type,
                        const Registry& registry, Diagnostics& diagnostics);

// Reports the keys of a graph input that do not fit its type or name a missing input. `port` is
// the input in Types. Part of check().
void check_keys(const Document& document, const GraphInput& input, const Port& port,
                Diagnostics& diagnostics);

// Reports former names of inputs that are names of other inputs, now or formerly. Part of check().
void check_renamed(const Document& document, Diagnostics& diagnostics);

// Returns "is a former name of 'wear', which is set too" for a value under a former name that has
// not become a value of the input; "" for another name. `set_once` is the remedy.
std::string set_twice(std::string_view name, const Table<GraphInput>& inputs);
inline constexpr auto set_once = "remove one of them";

}  // namespace wrinkle
