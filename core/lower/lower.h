// Lowers a graph to a module: every node that the outputs need is built once, and the result is a
// module with opaque gradients, to be expanded (ir/expand.h).
//
// * Sub-graphs are inlined or become functions by the rule in lower/functions.h. A function is
//   specialised for each kind of arguments (ir/open_input.h); calls with equal arguments are one
//   value. A node in it is the instance below its first use, and its unconnected numbers are
//   parameters of that instance, for all uses.
// * An unconnected number is a parameter, also at its default; its value is clamped to the port's
//   hard range. A wire into a port with a hard range is clamped by an instruction.
// * A node in a sub-graph is the instance "outer/inner". The top graph's inputs are parameters with
//   `graph_input` set.
// * A muted node passes for each output an input of its type through, the first connected one, else
//   the first; if there is none the output is zero of its type (for a normal the surface's).
// * The gradients that a node makes are based on the surface, or on the normal at its input `base`
//   (of type normal). An input of type gradient that a height, derivative or normal is connected to
//   takes the base of the gradients it is joined with by wires; without any it is the surface.
// * Outputs of standard names (base/standard_outputs.h) are converted to their type; those of the
//   top graph get the name of their row. Its output `material` becomes an output for each channel
//   (lower/record.h) that the graph has no other output for. A gradient as output is its vector in
//   object space, a derivative its slope.
//
// Precondition: check() found no error. Constant stack; linear in the nodes that are built, however
// often functions are called.
#pragma once

#include <string>
#include <vector>

#include "base/limits.h"
#include "ir/module.h"
#include "lower/types.h"

namespace wrinkle {

class NamedFiles;

struct LowerOptions {
    uint64_t max_nodes = limit_of(Limit::graph_nodes);
    uint64_t max_values = limit_of(Limit::graph_values);  // beyond: an error, Lowered::over_limit
    // A graph of at most this many nodes, counted after complete inlining, has no functions.
    uint64_t inline_up_to = 256;
    std::vector<std::string> outputs;  // only these; empty: all
    NamedFiles* files = nullptr;       // known files of the project; null: none yet
    SrgbDecoder srgb = SrgbDecoder::sampler;
};

// Location of an entry of Module::nodes.
struct NodePlace {
    static constexpr uint32_t none = ~0u;
    uint32_t file = 0;     // in Project::files
    uint32_t node = none;  // in its document; none: the graph itself
};

struct Lowered {
    Module module;
    std::vector<NodePlace> places;  // by index in module.nodes
    bool over_limit = false;        // reported as an error: the module is not complete
};

Lowered lower(const Project& project, const Types& types, const LowerOptions& options,
              Diagnostics& diagnostics);

// Returns a diagnostic at the node that exceeded the limit. `places` are those of the module's
// nodes.
Diagnostic over_limit(const OverLimit& over, const Project& project,
                      const std::vector<NodePlace>& places);

// Reports the problems that a module's passes recorded, as diagnostics at their nodes.
void report_problems(const std::vector<Problem>& problems, const Module& module,
                     const Project& project, const std::vector<NodePlace>& places,
                     Diagnostics& diagnostics);

}  // namespace wrinkle
