// Ports that repeat, such as position_1, color_1, position_2, color_2: one item for each number
// from 1 on. A count port has the number of used items. Edits take the index of an item, from 0;
// values and wires of the later items move with them.
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

struct RepeatedPorts {
    const NodeType* type = nullptr;
    const Port* count = nullptr;          // nullptr: the type has no such ports
    std::vector<std::string_view> names;  // without the number: "position", "color"

    explicit operator bool() const { return count != nullptr; }
    size_t least() const { return static_cast<size_t>(count->hard_min); }
    size_t most() const { return static_cast<size_t>(count->hard_max); }
    size_t count_in(const Node& node) const;
    const Port& port(std::string_view name, size_t item) const;
};

struct RepeatedName {
    std::string_view name;
    PortType type = PortType::float_;
};
// Finds the ports of a type by the name of the count and the names and types of an item's ports.
// None for nullptr and for sub-graphs, which are edited as graphs.
RepeatedPorts find_repeated(const NodeType* type, std::string_view count,
                            std::initializer_list<RepeatedName> names);

std::string repeated_name(std::string_view name, size_t item);  // "position_1" for 0

// Inserts an item with the defaults of its ports; nothing if all are used.
Document with_item(const Document& document, const Node& node, const RepeatedPorts& ports,
                   size_t item);
// Removes an item; nothing if only the least number is left.
Document without_item(const Document& document, const Node& node, const RepeatedPorts& ports,
                      size_t item);
// Sets all numbers of a port; it loses its wire.
Document with_numbers(Document document, const std::string& node, const Port& port,
                      const std::array<double, 4>& numbers);

}  // namespace wrinkle::editor
