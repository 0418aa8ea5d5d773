// Registry of node types: built-in types and those of plugins, as validated copies of their
// descriptors.
//
// Descriptors of plugins are untrusted: only members within their `size` are read, and null
// strings, numbers out of range and duplicate ids are refused. A plugin is added completely or not
// at all; every fault is a diagnostic that names the plugin's origin, the node and the port.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/diagnostics.h"
#include "base/texture_options.h"
#include "registry/port_type.h"

struct wr_builder;
struct wr_plugin;

namespace wrinkle {

// Kind and Default have the numbers of WR_KIND_* and WR_DEFAULT_* (wrinkle/plugin.h).
struct Port {
    enum class Kind : uint8_t { input = 1, output, choice, count, flag, field };
    enum class Default : uint8_t {
        none,  // required; a gradient or a derivative is flat, a material empty
        constant,
        surface,
        absent  // no value: no channel is added to a material; default_value is only displayed
    };
    Kind kind = Kind::input;
    PortType type = PortType::float_;  // for inputs, outputs and fields
    std::string name;
    std::string doc;   // one line
    std::string unit;  // "m", "deg", "x" or ""
    Default default_kind = Default::none;
    uint32_t default_surface = 0;           // WR_SURFACE_*: the default, or a field's domain
    std::array<double, 4> default_value{};  // a choice: its index, a flag: 0 or 1
    double soft_min = 0, soft_max = 0;      // slider range; equal: none
    double hard_min = 0, hard_max = 0;      // equal: none
    bool clamps_wires = true;  // false: input of a sub-graph, clamped by the ports that read it
    std::vector<std::string> choices;
    Encoding encoding = Encoding::linear;  // for an image given as a bare path

    bool is_value() const { return kind == Kind::input || kind == Kind::field; }  // takes a wire
    bool is_option() const { return !is_value() && kind != Kind::output; }  // constant in build()
    bool is_required() const;  // an image, or a number without a default
    bool has_hard_range() const { return hard_min != hard_max; }
    bool has_soft_range() const { return soft_min != soft_max; }
};

struct Rename {
    uint32_t version = 0;  // first version with the new name
    std::string old_name;
    std::string new_name;
};

class PluginCode;  // registry/plugin_code.h

// Reason why a node cannot be built, and a hint.
struct Unbuilt {
    std::string why, remedy;
};

struct NodeType {
    using Build = void (*)(const wr_builder*);

    std::string id;
    std::string title;
    std::string doc;
    std::string family;
    uint32_t version = 1;
    std::vector<Port> ports;
    std::vector<Rename> renames;
    Build build = nullptr;             // null if `code` is set
    std::shared_ptr<PluginCode> code;  // code of a plugin, run in another process
    size_t code_index = 0;             // index of this node in it
    std::string origin;                // "built-in" or the plugin's path

    static constexpr uint32_t none = ~0u;
    // Returns the index of a port or `none`. Inputs, options and fields share one name space,
    // outputs have their own.
    uint32_t find_input(std::string_view name) const;
    uint32_t find_output(std::string_view name) const;
    // Makes the calls of the node's build(). Returns false, without any call, if its plugin's code
    // cannot be used or did not complete. Thread-safe.
    bool run(const wr_builder* builder, Unbuilt& reason) const;
};

class Registry {
public:
    static constexpr std::string_view built_in = "built-in";

    // Copies the plugin's nodes in their order; returns false and adds nothing on any fault.
    bool add_plugin(const wr_plugin* plugin, std::string_view origin, Diagnostics& diagnostics);
    // As above with node types that were read before from `origin`.
    bool add(std::vector<NodeType> types, std::string_view origin, Diagnostics& diagnostics);

    // Returns nullptr for an unknown id. Pointers stay valid during the lifetime of the registry.
    const NodeType* find(std::string_view id) const;
    const std::deque<NodeType>& list() const { return types_; }  // in the order of adding
    std::vector<std::string> ids() const;

private:
    bool report_taken(const std::vector<NodeType>& types, std::string_view origin,
                      Diagnostics& diagnostics) const;

    std::deque<NodeType> types_;
    std::unordered_map<std::string_view, const NodeType*> by_id_;
};

}  // namespace wrinkle
