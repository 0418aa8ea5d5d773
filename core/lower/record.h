// Values of the port type `material`: records of channels, each a value with a name.
//
// A record exists while a graph is lowered and not in its module: the value of a wire is an opaque
// leaf that names it, and nodes read and write its channels. So a material costs its channels.
// The channels of standard names (base/standard_outputs.h) have the type of that output, but a bump
// is a gradient, not a normal. Internal to core/lower.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/module.h"
#include "registry/port_type.h"

namespace wrinkle {

struct Channel {
    std::string name;
    PortType type = PortType::float_;
    Id value = poison;
};
// In the order of the table, then by name.
using Record = std::vector<Channel>;

// Returns the type of a channel with a standard name.
std::optional<PortType> channel_type(std::string_view name);

class Records {
public:
    explicit Records(Module& module) : module_(module) {}

    Id add(Record record);
    // Returns true for a value that add() returned.
    bool has(Id value) const {
        return module_[value].op == Op::material_ && module_[value].extra < records_.size();
    }
    const Record& of(Id material) const;  // poison has no channels

    // Returns an error message if a channel cannot have this name and type, else "".
    std::string problem(Id material, std::string_view name, PortType type) const;
    // Returns the value of a channel; if the material does not have it, the default of the output
    // of that name, else zero. The default of emission_luminance is `nits_of_unit_emission` where
    // the material has an emission. Precondition of channel() and with(): problem() returns "".
    Id channel(Id material, std::string_view name, PortType type) const;
    Id with(Id material, Channel channel);
    // All channels of both: (1 - t) one + t other; tangents are normalised.
    Id mixed(Id one, Id other, Id t);

private:
    Module& module_;
    std::vector<Record> records_;
};

}  // namespace wrinkle
