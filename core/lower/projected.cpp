#include <algorithm>
#include <array>

#include "graph/document.h"
#include "lower/check.h"

namespace wrinkle {
namespace {

constexpr int longest_chain = 64;  // maximum number of uv nodes followed

const Port* input_of(const NodeType& type, std::string_view name) {
    const uint32_t index = type.find_input(name);
    return index == NodeType::none ? nullptr : &type.ports[index];
}

bool is_unit_by_default(const NodeType& type) {
    const Port* scale = input_of(type, "scale");
    if (!scale || scale->choices.empty()) return false;
    const auto chosen = static_cast<size_t>(scale->default_value[0]);
    return scale->choices.at(chosen) == "unit" &&
           std::find(scale->choices.begin(), scale->choices.end(), "surface") !=
               scale->choices.end();
}

bool makes_bump(const NodeType& type) {
    return std::any_of(type.ports.begin(), type.ports.end(), [](const Port& port) {
        return port.kind == Port::Kind::output && port.type == PortType::gradient_;
    });
}

bool is_projection(const NodeType& type) {
    constexpr std::array<std::string_view, 3> flat = {"planar_uv", "plane_uv", "box_uv"};
    return std::find(flat.begin(), flat.end(), type.id) != flat.end();
}

// Returns the node that makes this one's uv from the position; null if there is none.
const Node* projection_behind(const Document& document, const Node* node,
                              const Registry& registry) {
    for (int step = 0; step < longest_chain; ++step) {
        const Input* uv = node->find("uv");
        if (!uv || uv->kind != Input::Kind::link) return nullptr;
        node = document.find(uv->link.node);
        const NodeType* type = node ? registry.find(node->type) : nullptr;
        if (!type || type->family != "uv") return nullptr;
        if (is_projection(*type)) return node;
    }
    return nullptr;
}

}  // namespace

void warn_of_projection(const Document& document, const Node& node, const NodeType& type,
                        const Registry& registry, Diagnostics& diagnostics) {
    if (node.muted || node.find("scale")) return;
    if (!makes_bump(type) || !is_unit_by_default(type)) return;
    const Node* projection = projection_behind(document, &node, registry);
    if (!projection) return;
    Diagnostic warning =
        diagnose(document, node,
                 "'" + projection->id +
                     "' projects the position, and with the scale 'unit' the map is not "
                     "the bump that triplanar nodes make of it",
                 "\"scale\": \"surface\" makes it that bump; \"scale\": \"unit\" keeps this one");
    warning.severity = Severity::warning;
    diagnostics.add(std::move(warning));
}

}  // namespace wrinkle
