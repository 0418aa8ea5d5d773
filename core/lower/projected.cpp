#include <algorithm>
#include <array>

#include "graph/document.h"
#include "lower/check.h"

namespace wrinkle {
namespace {

constexpr int longest_chain = 64;  // maximum number of uv nodes followed

bool is_unit_by_default(const NodeType& type) {
    const uint32_t index = type.find_input("scale");
    if (index == NodeType::none) return false;
    const Port& scale = type.ports[index];
    return std::ranges::count(scale.choices, "surface") > 0 &&
           scale.choices.at(static_cast<size_t>(scale.default_value[0])) == "unit";
}

bool makes_bump(const NodeType& type) {
    return std::ranges::any_of(type.ports, [](const Port& port) {
        return port.kind == Port::Kind::output && port.type == PortType::gradient_;
    });
}

bool is_projection(const NodeType& type) {
    constexpr std::array<std::string_view, 3> flat = {"planar_uv", "plane_uv", "box_uv"};
    return std::ranges::count(flat, type.id) > 0;
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
        diagnose(document, node, RuleId::projection_scale,
                 "'" + projection->id +
                     "' projects the position, and with the scale 'unit' the map is not "
                     "the bump that triplanar nodes make of it",
                 "\"scale\": \"surface\" makes it that bump; \"scale\": \"unit\" keeps this one");
    warning.severity = Severity::warning;
    diagnostics.add(std::move(warning));
}

}  // namespace wrinkle
