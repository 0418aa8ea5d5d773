#include "lower/conversion.h"

#include <algorithm>
#include <array>

#include "lower/literal.h"

namespace wrinkle {
namespace {

struct Row {
    PortType from, to;
    Conversion conversion;
};

using enum PortType;
constexpr std::array table = {
    Row{float_, height_, Conversion::rename},
    Row{height_, float_, Conversion::rename},
    Row{vec3_, color_, Conversion::rename},
    Row{color_, vec3_, Conversion::rename},
    Row{float_, color_, Conversion::gray},
    Row{height_, color_, Conversion::gray},
    Row{height_, gradient_, Conversion::differentiate},
    Row{float_, gradient_, Conversion::differentiate},
    Row{derivative_, gradient_, Conversion::apply_frame},
    Row{normal_, gradient_, Conversion::take_normal},
    Row{gradient_, normal_, Conversion::resolve},
    Row{float_, normal_, Conversion::differentiate_and_resolve},
    Row{height_, normal_, Conversion::differentiate_and_resolve},
    Row{derivative_, normal_, Conversion::apply_frame_and_resolve},
};

constexpr std::array<std::string_view, 10> docs = {
    "does not convert",
    "passes unchanged",
    "the same numbers, another meaning",
    "the gray of that value",
    "differentiates the height along the surface",
    "applies the derivative's frame",
    "takes the perturbation out of the normal",
    "resolves the gradient to a normal",
    "differentiates the height along the surface and resolves it to a normal",
    "applies the derivative's frame and resolves it to a normal",
};

// Returns true for a node that converts one into the other: its first input has type `from`, its
// first output type `to`, and all further inputs default to a surface property.
bool makes(const NodeType& type, PortType from, PortType to) {
    const Port* output = nullptr;
    const Port* input = nullptr;
    for (const Port& port : type.ports) {
        if (port.kind == Port::Kind::output && !output) output = &port;
        if (!port.is_value()) continue;
        if (input && port.default_kind != Port::Default::surface) return false;
        if (!input) input = &port;
    }
    return input && input->type == from && output && output->type == to;
}

}  // namespace

Conversion conversion(PortType from, PortType to) {
    if (from == to) return Conversion::same;
    for (const Row& row : table)
        if (row.from == from && row.to == to) return row.conversion;
    return Conversion::illegal;
}

std::string_view doc(Conversion conversion) {
    return docs[static_cast<size_t>(conversion)];
}

std::vector<PortType> accepted_by(PortType to) {
    std::vector<PortType> types{to};
    for (uint32_t i = 1; i <= port_type_count; ++i) {
        const auto from = static_cast<PortType>(i);
        const Conversion found = conversion(from, to);
        if (found != Conversion::illegal && found != Conversion::same) types.push_back(from);
    }
    return types;
}

std::string alternative(PortType from, PortType to, const Registry& registry) {
    std::vector<std::string> names;
    for (const PortType type : accepted_by(to))
        names.emplace_back(name_of(type));
    const std::string text = "it takes " + one_of(names);
    for (const NodeType& type : registry.list())
        if (type.family != "comparison" && makes(type, from, to))
            return text + "; node '" + type.id + "' makes " + std::string(name_of(to)) + " from " +
                   std::string(name_of(from));
    return text;
}

}  // namespace wrinkle
