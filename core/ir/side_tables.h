// Data of a module other than its instructions: nodes, parameters, resources, names, outputs and
// problems. Does not include ir/module.h.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/rules.h"
#include "base/texture_options.h"

namespace wrinkle {

class Module;               // ir/module.h
enum class Type : uint8_t;  // ir/op.h

// Index of an instruction. Index 0 has two names, defined in ir/module.h: `poison` (error), `no_id`
// (absent).
using Id = uint32_t;
inline constexpr Id no_id = 0;
inline constexpr Id poison = 0;

// A number the user may change. Its index in Module::parameters is its identity.
struct Parameter {
    uint32_t node = 0;  // Module::nodes; 0 for a graph input
    std::string port;   // "amount"; for a graph input its name
    Type type{};
    std::array<double, 4> value{};
    bool graph_input = false;  // stays a uniform when parameters are baked
};

// An image that shaders sample. Equal file and options are one resource.
struct Resource {
    std::string file;  // resolved path, to be opened
    std::string name;  // as written in the graph
    TextureOptions options;
    struct Reader {
        uint32_t node;
        std::string port;
    };
    std::vector<Reader> readers;  // node ports, in order of lowering
};

// A node instance. Entry 0 is the graph itself.
struct NodeInstance {
    std::string path;    // "weave"; in a sub-graph "strap/weave"
    uint32_t title = 0;  // its type's title, index in Module::titles
};

// The name of a value in generated source.
struct Named {
    Id value;
    uint32_t node;         // the node that names it; 0: the surface point, for all nodes
    std::string name;      // "gradient"
    bool output;           // an output of that node: a separate statement; preferred to other names
    bool derived = false;  // made from the name of the value of which it is the derivative
    bool unshared = false;  // several nodes name it alike, and it stays with the first
    std::string comment =
        {};  // if the value is a constant: its name is global, and has this comment
};

struct ModuleOutput {
    std::string name;        // "normal"
    uint32_t port_type = 0;  // WR_PORT_*
    Id value = no_id;
};

struct Problem {
    RuleId rule;
    uint32_t node;
    std::string message;
    std::string expected;
};

}  // namespace wrinkle
