#include "registry/listing.h"
#include "registry/port_type.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "base/printable.h"
#include "base/text.h"
#include "wrinkle/plugin.h"

namespace wrinkle {
namespace {

static_assert(Port::Kind{WR_KIND_INPUT} == Port::Kind::input &&
              Port::Kind{WR_KIND_OUTPUT} == Port::Kind::output &&
              Port::Kind{WR_KIND_CHOICE} == Port::Kind::choice &&
              Port::Kind{WR_KIND_COUNT} == Port::Kind::count &&
              Port::Kind{WR_KIND_FLAG} == Port::Kind::flag &&
              Port::Kind{WR_KIND_FIELD} == Port::Kind::field);
static_assert(Port::Default{WR_DEFAULT_NONE} == Port::Default::none &&
              Port::Default{WR_DEFAULT_CONSTANT} == Port::Default::constant &&
              Port::Default{WR_DEFAULT_SURFACE} == Port::Default::surface &&
              Port::Default{WR_DEFAULT_ABSENT} == Port::Default::absent);

constexpr uint32_t max_nodes = 10'000;
constexpr uint32_t max_ports = 256;  // also the limit of choices and renames
constexpr size_t max_text = 4096;
constexpr size_t max_faults = 20;  // per plugin; reading stops there

// Sizes of the structs in the first version of the ABI, in which each ends with a pointer; later
// versions have more members.
constexpr size_t first_plugin = offsetof(wr_plugin, get_extension) + sizeof(void*);
constexpr size_t first_node = offsetof(wr_node, build) + sizeof(void*);
constexpr size_t first_port = offsetof(wr_port, encoding) + sizeof(void*);
constexpr size_t first_rename = offsetof(wr_rename, new_name) + sizeof(void*);

// Fills with zeros if the plugin's struct is shorter.
template <class T>
bool read_struct(const T* source, size_t first_size, T& copy) {
    copy = {};
    if (source->size < first_size) return false;
    std::memcpy(&copy, source, std::min<size_t>(source->size, sizeof(T)));
    return true;
}

class Reader {
public:
    Reader(std::string_view origin, Diagnostics& diagnostics)
        : origin_(origin), diagnostics_(diagnostics) {}

    bool fine() const { return faults_ == 0; }
    bool had_enough() const { return faults_ >= max_faults; }

    bool plugin(const wr_plugin* source, wr_plugin& copy) {
        if (!source) return fault("its descriptor is null");
        if (!read_struct(source, first_plugin, copy)) return too_small(source->size);
        if (copy.abi != WR_ABI)
            return fault("it is made for plugin interface " + std::to_string(copy.abi),
                         "this program has interface " + std::to_string(WR_ABI));
        std::string ignored;
        text(copy.id, "the plugin's id", ignored);
        text(copy.version, "the plugin's version", ignored);
        if (copy.node_count > max_nodes) return too_many(copy.node_count, " nodes", max_nodes);
        if (copy.node_count > 0 && !copy.nodes) return fault("its list of nodes is null");
        return true;
    }

    void node(const wr_node* source, uint32_t index, NodeType& type) {
        node_ = "number " + std::to_string(index);
        wr_node copy;
        if (!source) return void(fault("its descriptor is null"));
        if (!read_struct(source, first_node, copy)) return void(too_small(source->size));
        if (!name(copy.id, "the id", type.id)) return;
        if (!type.id.empty()) node_ = type.id;
        if (!is_name(type.id))
            fault("its id is not lower_snake_case", "letters a-z, digits and _, at most 64");
        if (type.id == reroute_type) fault("this id is reserved");
        text(copy.title, "the title", type.title);
        text(copy.doc, "the doc", type.doc);
        text(copy.family, "the family", type.family);
        type.version = copy.version;
        type.origin = origin_;
        type.build = copy.build;
        if (copy.version == 0) fault("its version is 0", "versions count from 1");
        if (!copy.build) fault("its build function is null");
        ports(copy, type);
        renames(copy, type);
    }

    void duplicate(const std::string& id) {
        node_ = id;
        fault("the plugin has two nodes of this id");
    }

private:
    // Returns false, for use in a return statement.
    bool fault(std::string message, std::string expected = {}) {
        ++faults_;
        diagnostics_.add({.rule = RuleId::plugin,
                          .where = Location{origin_},
                          .node = node_,
                          .message = port_.empty() ? std::move(message) : port_ + ": " + message,
                          .expected = std::move(expected)});
        return false;
    }

    bool too_small(uint32_t size) {
        return fault("its descriptor has the impossible size " + std::to_string(size));
    }

    bool too_many(uint32_t count, const char* what, uint32_t max) {
        return fault("it claims " + std::to_string(count) + what, "at most " + std::to_string(max));
    }

    // Reads one line of text. `copy` is always printable; "" if the result is false.
    bool text(const char* source, const char* what, std::string& copy, size_t max_size = max_text) {
        copy.clear();
        if (!source) return fault(std::string(what) + " is null");
        const std::string_view found(source, strnlen(source, max_size + 1));
        if (found.size() > max_size)
            return fault(std::string(what) + " has no end within " + std::to_string(max_size) +
                         " bytes");
        if (!is_utf8(found)) return fault(std::string(what) + " is not valid UTF-8");
        if (printable(found) != found)
            return fault(std::string(what) + " holds a control character", "one line of text");
        copy = found;
        return true;
    }

    bool name(const char* source, const char* what, std::string& copy) {
        return text(source, what, copy, max_name);
    }

    void ports(const wr_node& node, NodeType& type) {
        if (node.port_count > max_ports)
            return void(too_many(node.port_count, " ports", max_ports));
        if (node.port_count > 0 && !node.ports) return void(fault("its list of ports is null"));
        bool has_output = false;
        for (uint32_t i = 0; i < node.port_count; ++i) {
            port_ = "port number " + std::to_string(i);
            Port copy;
            if (port(node.ports[i], copy) && is_duplicate(type, copy))
                fault("there is another port of this name");
            has_output = has_output || copy.kind == Port::Kind::output;
            type.ports.push_back(std::move(copy));
        }
        port_.clear();
        if (!has_output) fault("it has no output");
    }

    static bool is_duplicate(const NodeType& type, const Port& port) {
        const bool output = port.kind == Port::Kind::output;
        const uint32_t i = output ? type.find_output(port.name) : type.find_input(port.name);
        return i != NodeType::none;
    }

    bool port(const wr_port* source, Port& port) {
        wr_port copy;
        if (!source) return fault("its descriptor is null");
        if (!read_struct(source, first_port, copy)) return too_small(source->size);
        if (!name(copy.name, "the name", port.name)) return false;
        port_ = "port '" + port.name + "'";
        if (!is_name(port.name))
            fault("its name is not lower_snake_case", "letters a-z, digits and _, at most 64");
        text(copy.doc, "the doc", port.doc);
        if (copy.unit) text(copy.unit, "the unit", port.unit);
        if (copy.kind < WR_KIND_INPUT || copy.kind > WR_KIND_FIELD)
            return fault("its kind " + std::to_string(copy.kind) + " does not exist");
        port.kind = static_cast<Port::Kind>(copy.kind);
        if (port.is_option()) return option(copy, port);
        if (copy.type < 1 || copy.type > port_type_count)
            return fault("its type " + std::to_string(copy.type) + " does not exist");
        port.type = static_cast<PortType>(copy.type);
        if (port.kind == Port::Kind::output) return true;
        return ranges(copy, port) && value(copy, port);
    }

    bool ranges(const wr_port& source, Port& port) {
        if (!(source.soft_min <= source.soft_max && source.hard_min <= source.hard_max))
            return fault("a range ends before it begins");
        port.soft_min = source.soft_min;
        port.soft_max = source.soft_max;
        port.hard_min = source.hard_min;
        port.hard_max = source.hard_max;
        return true;
    }

    bool value(const wr_port& source, Port& port) {
        if (source.encoding) {
            std::string word;
            if (!name(source.encoding, "the encoding", word)) return false;
            const auto encoding = encoding_named(word);
            if (!encoding) return fault("its encoding " + json_quoted(word) + " does not exist");
            port.encoding = *encoding;
        }
        const bool field = port.kind == Port::Kind::field;
        if (field && lanes_of(port.type) == 0 && port.type != PortType::derivative_)
            return fault("a field of " + std::string(name_of(port.type)) + " cannot be",
                         "fields are of numbers or slopes");
        if (source.default_kind > WR_DEFAULT_ABSENT)
            return fault("its kind of default " + std::to_string(source.default_kind) +
                         " does not exist");
        port.default_kind = static_cast<Port::Default>(source.default_kind);
        if (field || port.default_kind == Port::Default::surface) {
            if (source.default_surface >= surface_properties().size())
                return fault("its surface property " + std::to_string(source.default_surface) +
                             " does not exist");
            port.default_surface = source.default_surface;
        }
        return default_value(source, port);
    }

    bool default_value(const wr_port& source, Port& port) {
        if (port.default_kind == Port::Default::none) return true;
        const std::string type(name_of(port.type));
        const bool absent = port.default_kind == Port::Default::absent;
        if (lanes_of(port.type) == 0)
            return absent || fault("a default of type " + type + " cannot be");
        if (port.default_kind == Port::Default::surface) {
            const SurfaceProperty& property = surface_properties()[port.default_surface];
            if (lanes_of(property.type) == lanes_of(port.type)) return true;
            return fault("its default surface." + std::string(property.name) + " is not of type " +
                         type);
        }
        for (int i = 0; i < lanes_of(port.type); ++i) {
            const double number = source.default_value[i];
            if (!std::isfinite(number)) return fault("its default is not finite");
            port.default_value[static_cast<size_t>(i)] = number;
            if (!in_range(port, number)) return false;
        }
        return true;
    }

    bool in_range(const Port& port, double number) {
        if (!port.has_hard_range()) return true;
        if (number >= port.hard_min && number <= port.hard_max) return true;
        return fault("its default " + shortest(number) + " is outside its range " +
                     shortest(port.hard_min) + " to " + shortest(port.hard_max));
    }

    bool option(const wr_port& source, Port& port) {
        if (!ranges(source, port)) return false;
        const double number = source.default_value[0];
        if (!(std::abs(number) <= 1e9) || number != std::floor(number))
            return fault("its default is not an integer");
        port.default_kind = Port::Default::constant;
        port.default_value[0] = number;
        if (port.kind == Port::Kind::count) return in_range(port, number);
        if (port.kind == Port::Kind::choice && !choices(source, port)) return false;
        const double last =
            port.kind == Port::Kind::flag ? 1 : static_cast<double>(port.choices.size()) - 1;
        if (number < 0 || number > last)
            return fault("its default " + shortest(number) + " is outside 0 to " + shortest(last));
        return true;
    }

    bool choices(const wr_port& source, Port& port) {
        if (source.choice_count == 0 || !source.choices) return fault("it has no choices");
        if (source.choice_count > max_ports)
            return too_many(source.choice_count, " choices", max_ports);
        for (uint32_t i = 0; i < source.choice_count; ++i) {
            std::string name;
            if (!this->name(source.choices[i], "the name of a choice", name)) return false;
            if (!is_name(name))
                return fault("its choice " + json_quoted(name) + " is not lower_snake_case");
            if (std::ranges::find(port.choices, name) != port.choices.end())
                return fault("its choice '" + name + "' occurs twice");
            port.choices.push_back(std::move(name));
        }
        return true;
    }

    void renames(const wr_node& node, NodeType& type) {
        if (node.rename_count > max_ports || (node.rename_count > 0 && !node.renames))
            return void(fault("its list of renamed ports is null or too long"));
        for (uint32_t i = 0; i < node.rename_count; ++i) {
            Rename rename;
            wr_rename copy;
            if (!node.renames[i] || !read_struct(node.renames[i], first_rename, copy)) {
                fault("a renamed port is null or has an impossible size");
                continue;
            }
            if (!name(copy.old_name, "the old name of a port", rename.old_name)) continue;
            if (!name(copy.new_name, "the new name of a port", rename.new_name)) continue;
            rename.version = copy.version;
            if (rename.version < 2 || rename.version > type.version)
                fault("port '" + rename.old_name + "' was renamed in version " +
                          std::to_string(rename.version),
                      "expected 2 to " + std::to_string(type.version));
            type.renames.push_back(std::move(rename));
        }
        chains(type);
    }

    // Renames are applied version by version: within one version they must not form chains or
    // cycles.
    void chains(const NodeType& type) {
        for (const Rename& first : type.renames)
            for (const Rename& second : type.renames)
                if (first.version == second.version && first.new_name == second.old_name)
                    fault("port '" + first.old_name + "' is renamed to '" + first.new_name +
                              "', which is renamed in the same version",
                          "one step a version");
    }

    std::string origin_;
    Diagnostics& diagnostics_;
    std::string node_;
    std::string port_;
    size_t faults_ = 0;
};

}  // namespace

bool read_plugin(const wr_plugin* plugin, wr_plugin& copy) {
    return read_struct(plugin, first_plugin, copy);
}

bool read_descriptors(const wr_plugin* plugin, std::string_view origin,
                      std::vector<NodeType>& types, Diagnostics& diagnostics) {
    Reader reader(origin, diagnostics);
    wr_plugin copy;
    if (!reader.plugin(plugin, copy)) return false;
    for (uint32_t i = 0; i < copy.node_count && !reader.had_enough(); ++i) {
        NodeType type;
        reader.node(copy.nodes[i], i, type);
        const auto same = [&](const NodeType& other) { return other.id == type.id; };
        if (!type.id.empty() && std::ranges::any_of(types, same)) reader.duplicate(type.id);
        types.push_back(std::move(type));
    }
    return reader.fine();
}

}  // namespace wrinkle
