#include "lower/types.h"

#include <algorithm>

#include "base/text.h"
#include "graph/depth_first.h"
#include "graph/order.h"
#include "graph/subgraph.h"
#include "lower/conversion.h"
#include "lower/literal.h"
#include "wrinkle/plugin.h"

namespace wrinkle {
namespace {

std::deque<NodeType> make_reroutes() {
    std::deque<NodeType> types;
    for (uint32_t i = 1; i <= port_type_count; ++i) {
        NodeType& type = types.emplace_back();
        type.id = reroute_type;
        type.title = "Reroute";
        type.doc = "Passes its input on; for tidy wires.";
        type.family = "layout";
        type.origin = Registry::built_in;
        Port& in = type.ports.emplace_back();
        in.name = "in";
        in.doc = "The value";
        in.type = static_cast<PortType>(i);
        Port out = in;
        out.kind = Port::Kind::output;
        out.name = "out";
        out.doc = "The same";
        type.ports.push_back(std::move(out));
    }
    return types;
}

const NodeType* reroute_of(PortType type) {
    static const std::deque<NodeType> types = make_reroutes();
    return &types[static_cast<size_t>(type) - 1];
}

Port input_port(const GraphInput& input) {
    Port port;
    port.name = input.name;
    port.doc = input.doc;
    port.unit = input.unit;
    if (const auto slider = range_of(input.slider)) {
        port.soft_min = slider->least;
        port.soft_max = slider->most;
    }
    if (const auto limits = range_of(input.limits)) {
        port.hard_min = limits->least;
        port.hard_max = limits->most;
    }
    port.type = port_type_named(input.type).value_or(PortType::float_);
    port.kind = option_kind(input.type).value_or(Port::Kind::input);
    if (port.kind == Port::Kind::choice)
        for (const json::Member& choice : input.choices.children())
            port.choices.emplace_back(choice.value.as_string());
    const bool numbers = literal_numbers(input.default_value, port.type, port.default_value);
    if (lanes_of(port.type) == 0) return port;
    port.default_kind = Port::Default::constant;
    if (port.type == PortType::normal_ && !numbers) {
        port.default_kind = Port::Default::surface;
        port.default_surface = WR_SURFACE_normal;
    }
    return port;
}

void inherit(Port& port, const Port& from) {
    const Conversion wire = conversion(port.type, from.type);
    const bool same_numbers = wire == Conversion::same || wire == Conversion::rename;
    if (port.is_option() ? port.kind != from.kind : !from.is_value() || !same_numbers) return;
    if (port.choices.empty()) port.choices = from.choices;
    if (port.doc.empty()) port.doc = from.doc;
    if (port.unit.empty()) port.unit = from.unit;
    if (!port.has_soft_range()) {
        port.soft_min = from.soft_min;
        port.soft_max = from.soft_max;
    }
    if (!port.has_hard_range()) {
        port.hard_min = from.hard_min;
        port.hard_max = from.hard_max;
        port.clamps_wires = false;
    }
}

}  // namespace

std::optional<Port::Kind> option_kind(std::string_view type) {
    return enumerator_named<Port::Kind>(option_type_names, type,
                                        static_cast<int>(Port::Kind::choice));
}

std::vector<std::string> port_names(const NodeType& type, bool outputs) {
    std::vector<std::string> names;
    for (const Port& port : type.ports)
        if ((port.kind == Port::Kind::output) == outputs) names.push_back(port.name);
    return names;
}

std::vector<uint32_t> files_in_order(const Project& project) {
    DepthFirst walk(project.files.size());
    walk.visit(
        0, [&](uint32_t file) { return project.files[file].subgraphs.size(); },
        [&](uint32_t file, uint32_t node) { return project.files[file].subgraphs[node]; },
        [](uint32_t, uint32_t, uint32_t) {});
    return std::move(walk.order());
}

Types::Types(const Project& project, const Registry& registry)
    : project_(&project), files_(project.files.size()), graphs_(project.files.size()) {
    for (const uint32_t file : files_in_order(project))
        type_file(project, registry, file);
}

void Types::type_file(const Project& project, const Registry& registry, size_t file) {
    const Project::File& source = project.files[file];
    const Document& document = source.document;
    std::vector<const NodeType*>& types = files_[file].nodes;
    types.resize(document.nodes.size());
    for (size_t i = 0; i < document.nodes.size(); ++i) {
        const uint32_t inner = source.subgraphs[i];
        if (inner != Project::File::none)
            types[i] = &graphs_[inner];
        else if (document.nodes[i]->type != reroute_type)
            types[i] = registry.find(document.nodes[i]->type);
    }
    type_reroutes(file);
    look_up_inputs(file);
    NodeType& type = graphs_[file];
    type.id = type_of_subgraph(source.path.filename().string());
    type.title = document.name.empty() ? source.path.stem().string() : document.name;
    type.family = "sub-graph";
    type.origin = source.path.string();
    add_graph_inputs(file);
    for (const Output& each : document.outputs) {
        Port port;
        port.kind = Port::Kind::output;
        port.name = each.name;
        const auto found = output(file, each);
        if (!found) continue;
        port.type = *found;
        type.ports.push_back(std::move(port));
    }
}

void Types::add_graph_inputs(size_t file) {
    const Document& document = project_->files[file].document;
    struct Readers {
        size_t count = 0;
        const Port* port = nullptr;
    };
    std::vector<Readers> readers(document.inputs.size());
    for (size_t n = 0; n < document.nodes.size() && !readers.empty(); ++n) {
        const std::span<const NamedInput> named = inputs(file, n);
        for (size_t k = 0; k < named.size(); ++k) {
            const Link& link = document.nodes[n]->inputs[k].link;
            const size_t input =
                link.is_input() ? document.inputs.index_of(link.port) : Table<GraphInput>::npos;
            if (input == Table<GraphInput>::npos || named[k].port == NodeType::none) continue;
            ++readers[input].count;
            readers[input].port = &of(file, n)->ports[named[k].port];
        }
    }
    for (size_t i = 0; i < readers.size(); ++i) {
        Port port = input_port(document.inputs[i]);
        if (readers[i].count == 1) inherit(port, *readers[i].port);
        if (port.is_option())
            port.default_value[0] =
                literal_option(document.inputs[i].default_value, port).value_or(0);
        graphs_[file].ports.push_back(std::move(port));
    }
}

// Types each reroute after the one that it reads; reroutes in a cycle have no type.
void Types::type_reroutes(size_t file) {
    const Table<NodePtr>& nodes = project_->files[file].document.nodes;
    std::vector<bool> seen(nodes.size(), false);
    std::vector<size_t> chain;
    for (size_t i = 0; i < nodes.size(); ++i) {
        for (size_t k = i; k < nodes.size() && nodes[k]->type == reroute_type && !seen[k];) {
            seen[k] = true;
            chain.push_back(k);
            const Input* in = nodes[k]->find("in");
            k = in && in->link.is_node() ? nodes.index_of(in->link.node) : nodes.npos;
        }
        for (; !chain.empty(); chain.pop_back())
            files_[file].nodes[chain.back()] = reroute(file, *nodes[chain.back()]);
    }
}

const NodeType* Types::reroute(size_t file, const Node& node) const {
    const Input* input = node.find("in");
    if (!input || input->kind != Input::Kind::link) return reroute_of(PortType::float_);
    const auto type = link(file, input->link);
    return type ? reroute_of(*type) : nullptr;
}

void Types::look_up_inputs(size_t file) {
    const Table<NodePtr>& nodes = project_->files[file].document.nodes;
    const Wires* wires = project_->files[file].document.wires();
    constexpr size_t inputs_of_a_node = 2;  // estimate
    File& found = files_[file];
    found.first.reserve(nodes.size() + 1);
    found.inputs.reserve(nodes.size() * inputs_of_a_node);
    for (size_t i = 0; i < nodes.size(); ++i) {
        found.first.push_back(static_cast<uint32_t>(found.inputs.size()));
        const NodeType* type = found.nodes[i];
        for (size_t k = 0; k < nodes[i]->inputs.size(); ++k) {
            const Input& input = nodes[i]->inputs[k];
            NamedInput& named = found.inputs.emplace_back();
            if (type) named.port = type->find_input(input.port);
            if (input.kind == Input::Kind::link)
                named.source = wires ? source(file, wires->of(i)[k], input.link.port)
                                     : source(file, input.link);
        }
    }
    found.first.push_back(static_cast<uint32_t>(found.inputs.size()));
}

LinkSource Types::source(size_t file, const Link& link) const {
    if (!link.is_node()) return {};
    const size_t node = project_->files[file].document.nodes.index_of(link.node);
    const bool found = node != Table<NodePtr>::npos;
    return source(file, found ? static_cast<uint32_t>(node) : LinkSource::none, link.port);
}

LinkSource Types::source(size_t file, uint32_t node, std::string_view output) const {
    LinkSource source;
    if (node == LinkSource::none) return source;
    source.node = node;
    if (const NodeType* type = of(file, node)) source.output = type->find_output(output);
    return source;
}

std::optional<PortType> Types::link(size_t file, const Link& link, LinkSource source) const {
    const Document& document = project_->files[file].document;
    if (link.is_surface()) {
        for (const SurfaceProperty& property : surface_properties())
            if (property.name == link.port) return property.type;
        return {};
    }
    if (link.is_input()) {
        const GraphInput* input = document.inputs.find(link.port);
        return input ? port_type_named(input->type) : std::nullopt;
    }
    if (source.output == LinkSource::none) return {};
    return of(file, source.node)->ports[source.output].type;
}

std::optional<PortType> Types::output(size_t file, const Output& output) const {
    if (const auto standard = standard_output(output.name)) return standard;
    return link(file, output.from.link);
}

}  // namespace wrinkle
