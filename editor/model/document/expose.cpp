#include "editor/model/document/expose.h"

#include <algorithm>
#include <cmath>

#include "editor/model/document/field.h"
#include "editor/model/document/wiring.h"
#include "graph/edit.h"
#include "graph/renamed.h"
#include "json/parse.h"
#include "lower/literal.h"
#include "registry/reference.h"

namespace wrinkle::editor {
namespace {

json::Value array_of_names(const std::vector<std::string>& names) {
    std::vector<json::Value> items;
    for (const std::string& name : names)
        items.push_back(json::Value::string(name));
    return json::Value::array(items);
}

json::Value range_value(double least, double most) {
    if (!(least < most) || !std::isfinite(most - least)) return {};
    return literal_of({least, most}, 2);
}

json::Value value_of(const Node& node, const Port& port) {
    if (const Input* input = node.find(port.name)) return input->value;
    if (port.is_required()) return {};
    Diagnostics ignored;
    return json::parse(default_json(port), "default", ignored).root;
}

std::string type_word(const Port& port) {
    return port.is_option() ? std::string(kind_word(port.kind)) : std::string(name_of(port.type));
}

std::string free_input_name(const Document& document, const Node& node, const Port& port) {
    const FormerNames former(document.inputs);
    const auto is_taken = [&](const std::string& name) {
        return document.inputs.find(name) || !former.current(name).empty();
    };
    if (!is_taken(port.name)) return port.name;
    const std::string stem = node.id + "_" + port.name;
    std::string name = stem;
    for (size_t n = 2; is_taken(name); ++n)
        name = stem + std::to_string(n);
    return name;
}

// Returns the value as a literal of the port, null if it does not fit. A number is that of all
// components.
json::Value fitting_literal(const json::Value& value, const Port& port) {
    if (value.is(json::Kind::null)) return {};
    const int lanes = port.is_value() ? lanes_of(port.type) : 0;
    json::Value literal = value;
    if (lanes > 1 && value.is(json::Kind::number))
        literal = json::Value::array(std::vector<json::Value>(static_cast<size_t>(lanes), value));
    const auto is_error = [](const LiteralProblem& p) { return p.severity == Severity::error; };
    return std::ranges::none_of(literal_problems(literal, port), is_error) ? literal
                                                                           : json::Value();
}

}  // namespace

std::string why_not_exposed(const Node& node, const Port& port) {
    const Input* input = node.find(port.name);
    if (port.kind == Port::Kind::output) return port.name + " is an output.";
    if (input && input->kind != Input::Kind::literal) return port.name + " has a wire.";
    if (port.is_option()) return {};
    if (port.type == PortType::image_ && !input)
        return "Choose an image for " + port.name + " first.";
    if (port.type != PortType::image_ && lanes_of(port.type) == 0)
        return port.name + " has no value.";
    if (!input && (port.default_kind == Port::Default::surface || port.is_required()))
        return port.name + " has no value.";
    return {};
}

std::vector<const Port*> exposable_ports(const Node& node, const NodeType& type) {
    std::vector<const Port*> ports;
    for (const Port& port : type.ports)
        if (why_not_exposed(node, port).empty()) ports.push_back(&port);
    return ports;
}

Exposed expose(const Document& document, const Node& node, const Port& port) {
    GraphInput input;
    input.name = free_input_name(document, node, port);
    input.type = type_word(port);
    input.default_value = value_of(node, port);
    input.unit = port.unit;
    if (port.kind == Port::Kind::choice) input.choices = array_of_names(port.choices);
    if (port.has_soft_range()) input.slider = range_value(port.soft_min, port.soft_max);
    if (port.kind == Port::Kind::count && port.has_hard_range())
        input.limits = range_value(port.hard_min, port.hard_max);
    const Link from{std::string(Link::input), input.name};
    return {connect(set_graph_input(document, input), from, node.id, port.name), input.name};
}

Document without_input(const Model& model, const Document& document, const std::string& name) {
    const GraphInput* input = document.inputs.find(name);
    if (!input) return document;
    Document changed = document;
    each_wire(document, [&](const Connection& wire) {
        if (!wire.from.is_input() || wire.from.port != name || wire.node.empty()) return;
        const Port* port = input_port(model.type_of(wire.node), wire.port);
        const json::Value literal =
            port ? fitting_literal(input->default_value, *port) : json::Value();
        if (!literal.is(json::Kind::null))
            changed = set_value(changed, wire.node, wire.port, literal);
    });
    return remove_graph_input(changed, name);
}

}  // namespace wrinkle::editor
