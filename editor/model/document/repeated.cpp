#include "editor/model/document/repeated.h"

#include <algorithm>
#include <array>

#include "editor/model/document/field.h"
#include "editor/model/document/model.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// Gives the port `to` the wire or the value of the port `from` of `node`.
Document with_moved(const Document& document, const Node& node, const Port& from, const Port& to) {
    const Input* input = node.find(from.name);
    if (input && input->kind == Input::Kind::link)
        return connect(document, input->link, node.id, to.name);
    return with_numbers(reset_value(document, node.id, to.name), node.id, to,
                        numbers_at(node, from));
}

Document with_item_moved(Document document, const Node& node, const RepeatedPorts& ports,
                         size_t from, size_t to) {
    for (const std::string_view name : ports.names)
        document = with_moved(document, node, ports.port(name, from), ports.port(name, to));
    return document;
}

Document with_item_reset(Document document, const Node& node, const RepeatedPorts& ports,
                         size_t item) {
    for (const std::string_view name : ports.names)
        document = reset_value(document, node.id, repeated_name(name, item));
    return document;
}

}  // namespace

size_t RepeatedPorts::count_in(const Node& node) const {
    return std::clamp(static_cast<size_t>(std::max(numbers_at(node, *count)[0], 0.0)), least(),
                      most());
}

const Port& RepeatedPorts::port(std::string_view name, size_t item) const {
    return *input_port(type, repeated_name(name, item));
}

std::string repeated_name(std::string_view name, size_t item) {
    return std::string(name) + "_" + std::to_string(item + 1);
}

RepeatedPorts find_repeated(const NodeType* type, std::string_view count,
                            std::initializer_list<RepeatedName> names) {
    const Port* counting = input_port(type, count);
    if (!counting || counting->kind != Port::Kind::count || subgraph_file(type->id)) return {};
    RepeatedPorts ports{type, counting, {}};
    if (counting->hard_min < 1 || counting->hard_max < counting->hard_min) return {};
    for (const RepeatedName& wanted : names) {
        ports.names.push_back(wanted.name);
        for (size_t i = 0; i < ports.most(); ++i) {
            const Port* port = input_port(type, repeated_name(wanted.name, i));
            if (!port || port->type != wanted.type) return {};
        }
    }
    return ports;
}

Document with_numbers(Document document, const std::string& node, const Port& port,
                      const std::array<double, 4>& numbers) {
    for (int lane = 0; lane < lanes_of_field(port); ++lane)
        document = with_number(document, node, port, lane, numbers[static_cast<size_t>(lane)]);
    return document;
}

Document with_item(const Document& document, const Node& node, const RepeatedPorts& ports,
                   size_t item) {
    const size_t count = ports.count_in(node);
    if (count >= ports.most() || item > count) return document;
    Document result =
        with_number(document, node.id, *ports.count, 0, static_cast<double>(count + 1));
    for (size_t i = count; i-- > item;)
        result = with_item_moved(result, node, ports, i, i + 1);
    return with_item_reset(result, node, ports, item);
}

Document without_item(const Document& document, const Node& node, const RepeatedPorts& ports,
                      size_t item) {
    const size_t count = ports.count_in(node);
    if (item >= count || count <= ports.least()) return document;
    Document result = document;
    for (size_t i = item; i + 1 < count; ++i)
        result = with_item_moved(result, node, ports, i + 1, i);
    result = with_item_reset(result, node, ports, count - 1);
    return with_number(result, node.id, *ports.count, 0, static_cast<double>(count - 1));
}

}  // namespace wrinkle::editor
