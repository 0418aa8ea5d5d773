#include "registry/registry.h"

#include "registry/descriptor.h"

namespace wrinkle {

bool Port::is_required() const {
    if (!is_value() || default_kind != Default::none) return false;
    return type != PortType::gradient_ && type != PortType::derivative_;
}

uint32_t NodeType::find_input(std::string_view port) const {
    for (uint32_t i = 0; i < ports.size(); ++i)
        if (ports[i].kind != Port::Kind::output && ports[i].name == port) return i;
    return none;
}

uint32_t NodeType::find_output(std::string_view port) const {
    for (uint32_t i = 0; i < ports.size(); ++i)
        if (ports[i].kind == Port::Kind::output && ports[i].name == port) return i;
    return none;
}

bool Registry::add_plugin(const wr_plugin* plugin, std::string_view origin,
                          Diagnostics& diagnostics) {
    std::vector<NodeType> types;
    bool fine = read_descriptors(plugin, origin, types, diagnostics);
    for (const NodeType& type : types) {
        const NodeType* other = find(type.id);
        if (!other) continue;
        fine = false;
        Diagnostic diagnostic;
        diagnostic.where.file = origin;
        diagnostic.node = type.id;
        diagnostic.message = "this id is taken: " + other->origin + " has a node of the same id";
        diagnostic.expected = "give one of them another id";
        diagnostics.add(std::move(diagnostic));
    }
    if (!fine) return false;
    for (NodeType& type : types) {
        const NodeType& stored = types_.emplace_back(std::move(type));
        by_id_.emplace(stored.id, &stored);
    }
    return true;
}

const NodeType* Registry::find(std::string_view id) const {
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? nullptr : found->second;
}

std::vector<std::string> Registry::ids() const {
    std::vector<std::string> result;
    for (const NodeType& type : types_)
        result.push_back(type.id);
    return result;
}

}  // namespace wrinkle
