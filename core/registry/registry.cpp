#include "registry/registry.h"

#include "base/mapped.h"
#include "registry/listing.h"
#include "registry/plugin_code.h"
#include "registry/recording.h"

namespace wrinkle {

bool Port::is_required() const {
    if (!is_value() || default_kind != Default::none) return false;
    return type != PortType::gradient_ && type != PortType::derivative_ &&
           type != PortType::material_;
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

bool NodeType::run(const wr_builder* builder, Unbuilt& reason) const {
    if (!code) return build(builder), true;
    std::vector<int32_t> options(ports.size(), 0);
    for (uint32_t p = 0; p < ports.size(); ++p)
        if (ports[p].is_option()) options[p] = builder->option(builder, p);
    const auto calls = code->calls(code_index, options, reason);
    const bool whole = calls && replay(*calls, builder);
    if (calls && !whole) reason.why = "its build() wrote over what it had recorded";
    if (!whole) reason.why = "the plugin " + origin + " cannot be used: " + reason.why;
    return whole;
}

bool Registry::add_plugin(const wr_plugin* plugin, std::string_view origin,
                          Diagnostics& diagnostics) {
    std::vector<NodeType> types;
    if (!read_descriptors(plugin, origin, types, diagnostics)) {
        report_taken(types, origin, diagnostics);
        return false;
    }
    return add(std::move(types), origin, diagnostics);
}

bool Registry::add(std::vector<NodeType> types, std::string_view origin, Diagnostics& diagnostics) {
    if (report_taken(types, origin, diagnostics)) return false;
    for (NodeType& type : types) {
        const NodeType& stored = types_.emplace_back(std::move(type));
        by_id_.emplace(stored.id, &stored);
    }
    return true;
}

bool Registry::report_taken(const std::vector<NodeType>& types, std::string_view origin,
                            Diagnostics& diagnostics) const {
    bool any = false;
    for (const NodeType& type : types) {
        const NodeType* other = find(type.id);
        if (!other) continue;
        any = true;
        diagnostics.add(
            {.rule = RuleId::plugin,
             .where = Location{std::string(origin)},
             .node = type.id,
             .message = "this id is taken: " + other->origin + " has a node of the same id",
             .expected = "give one of them another id"});
    }
    return any;
}

const NodeType* Registry::find(std::string_view id) const {
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? nullptr : found->second;
}

std::vector<std::string> Registry::ids() const {
    return mapped<std::string>(types_, &NodeType::id);
}

}  // namespace wrinkle
