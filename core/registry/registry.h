// The node types a program knows: the built-in ones and those of plugins, as copies of their
// descriptors, checked.
//
// A plugin's descriptors are read with suspicion: only members that their `size` covers, no null
// string, no number out of its range, no id twice. A plugin is taken whole or not at all; every
// fault of it is a diagnostic that names the plugin's origin, the node and the port.
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

namespace wrinkle {

struct Port {
    enum class Kind : uint8_t {
        input = WR_KIND_INPUT,
        output = WR_KIND_OUTPUT,
        choice = WR_KIND_CHOICE,
        count = WR_KIND_COUNT,
        flag = WR_KIND_FLAG,
        field = WR_KIND_FIELD,
    };
    enum class Default : uint8_t {
        none = WR_DEFAULT_NONE,  // required; a gradient or a derivative is flat
        constant = WR_DEFAULT_CONSTANT,
        surface = WR_DEFAULT_SURFACE,
    };
    Kind kind = Kind::input;
    PortType type = PortType::float_;  // of inputs, outputs and fields
    std::string name;
    std::string doc;   // one line
    std::string unit;  // "m", "deg", "x" or ""
    Default default_kind = Default::none;
    uint32_t default_surface = 0;           // WR_SURFACE_*: the default, or a field's domain
    std::array<double, 4> default_value{};  // of a choice its index, of a flag 0 or 1
    double soft_min = 0, soft_max = 0;      // the slider; equal: none
    double hard_min = 0, hard_max = 0;      // equal: none
    std::vector<std::string> choices;
    Encoding encoding = Encoding::linear;  // of an image: that of a bare path

    bool is_value() const { return kind == Kind::input || kind == Kind::field; }  // takes a wire
    bool is_option() const { return !is_value() && kind != Kind::output; }  // known while building
    bool is_required() const;  // an image, or a number without a default
    bool has_hard_range() const { return hard_min != hard_max; }
    bool has_soft_range() const { return soft_min != soft_max; }
};

struct Rename {
    uint32_t version = 0;  // since which
    std::string old_name;
    std::string new_name;
};

class PluginCode;  // registry/plugin_code.h

// Why a node cannot be built, and the remedy.
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
    Build build = nullptr;             // null where `code` has it
    std::shared_ptr<PluginCode> code;  // of a plugin, which runs elsewhere
    size_t code_index = 0;             // which node of it this is
    std::string origin;                // "built-in" or the plugin's path

    static constexpr uint32_t none = ~0u;
    // The index of a port: inputs, options and fields share one name space, outputs have their own.
    uint32_t find_input(std::string_view name) const;
    uint32_t find_output(std::string_view name) const;
    // Makes the calls of the node's build(). False, without any call, when its plugin's code cannot
    // be used or did not come to an end. Safe to call from several threads.
    bool run(const wr_builder* builder, Unbuilt& reason) const;
};

class Registry {
public:
    static constexpr std::string_view built_in = "built-in";

    // Copies the plugin's nodes in their order; false (and nothing added) when anything is wrong.
    bool add_plugin(const wr_plugin* plugin, std::string_view origin, Diagnostics& diagnostics);
    // The same with nodes that were read before, at `origin`.
    bool add(std::vector<NodeType> types, std::string_view origin, Diagnostics& diagnostics);

    // nullptr for an unknown id. Pointers stay valid while the registry lives.
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
