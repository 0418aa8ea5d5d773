// What stands on the canvas, as layout.h makes it from the document: cards with pins and fields,
// wires between them; and what of it lies under the pointer.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "graph/document.h"
#include "registry/registry.h"

namespace wrinkle::editor {

// A node on the canvas: one of the document, or one of the two at its borders. Lengths in canvas
// units, relative to the card's corner.
struct Pin {
    std::string port;
    PortType type = PortType::float_;
    bool known = true;  // false: of a node whose type is missing
    bool output = false;
    bool connected = false;
    float y = 0;
};
struct Field {
    std::string port;
    uint32_t index = 0;  // in NodeType::ports
    int lane = 0;
    int lanes = 0;  // 0: not a number
    float x = 0, y = 0, width = 0;
};
struct Card {
    enum class Kind : uint8_t { node, surface, inputs, outputs };
    // Of the outputs' card; no node can have it.
    static constexpr const char* outputs_id = "$output";

    Kind kind = Kind::node;
    std::string id;
    std::string label;  // the type's title
    const NodeType* type = nullptr;
    bool muted = false;
    ImVec2 at{0, 0}, size{0, 0};
    std::vector<Pin> pins;
    std::vector<Field> fields;
    float more_y = -1;  // of the row that shows all properties; -1: none
};
struct Wire {
    Link from;
    std::string node;  // "" for an output of the graph
    std::string port;
    ImVec2 start{0, 0}, end{0, 0};  // canvas units
    PortType from_type = PortType::float_, to_type = PortType::float_;
    bool known = true;
};
struct Layout {
    std::vector<Card> cards;  // in drawing order
    std::vector<Wire> wires;
    ImVec2 low{0, 0}, high{0, 0};
    const Card* find(std::string_view id, Card::Kind kind = Card::Kind::node) const;
};

// What lies under the pointer.
struct Hit {
    enum class Kind : uint8_t { nothing, card, header, pin, field, wire, more };
    Kind kind = Kind::nothing;
    size_t card = 0;  // in Layout::cards
    size_t part = 0;  // pin or field of the card; wire of the layout
};

}  // namespace wrinkle::editor
