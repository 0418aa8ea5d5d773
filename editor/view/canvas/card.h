// Drawing model of the canvas, built from the document by layout.h: cards with pins and fields,
// wires between them, and the result of a hit test.
#pragma once

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/document/wiring.h"
#include "graph/document.h"
#include "lower/conversion.h"
#include "registry/registry.h"

namespace wrinkle::editor {

// Axis-aligned rectangle; the default one contains nothing.
struct Extent {
    ImVec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};

    // The smallest rectangle that contains both points.
    static Extent between(ImVec2 a, ImVec2 b) {
        Extent box{a, a};
        box.add({b, b});
        return box;
    }

    bool empty() const { return low.x > high.x; }
    bool contains(ImVec2 at) const {
        return at.x >= low.x && at.y >= low.y && at.x < high.x && at.y < high.y;
    }
    bool contains(const Extent& inner) const {
        return inner.low.x >= low.x && inner.low.y >= low.y && inner.high.x <= high.x &&
               inner.high.y <= high.y;
    }
    bool touches(const Extent& other) const {
        return low.x <= other.high.x && low.y <= other.high.y && high.x >= other.low.x &&
               high.y >= other.low.y;
    }
    void add(const Extent& other) {
        low = {std::min(low.x, other.low.x), std::min(low.y, other.low.y)};
        high = {std::max(high.x, other.high.x), std::max(high.y, other.high.y)};
    }
};

// A card is a node of the document, or the card of the surface, the graph inputs or the outputs.
// Lengths in canvas units, relative to the card's corner.
struct Pin {
    std::string port;
    PortType type = PortType::float_;
    bool known = true;  // false: the node's type is missing
    bool output = false;
    bool connected = false;
    float y = 0;
    std::string label;      // as shown, truncated to fit
    bool in_field = false;  // a field shows its name
};
struct Field {
    std::string port;
    uint32_t index = 0;  // in NodeType::ports
    int lane = 0;
    int lanes = 0;  // 0: not a number
    float x = 0, y = 0, width = 0;
    std::string name, value;  // as shown, truncated to fit
    float part = -1;          // filled fraction of the slider, 0 to 1; below 0: no slider
    bool listed = false;      // a click opens a list
    // Shows its value, or `strip` or `values` of the card; a click on these opens an editor.
    enum class Shows : uint8_t { value, strip, curve };
    Shows shows = Shows::value;
};
struct Card {
    enum class Kind : uint8_t { node, surface, inputs, outputs };
    // Id of the outputs card; not a valid node id.
    static constexpr const char* outputs_id = "$output";

    Kind kind = Kind::node;
    std::string id;
    std::string label;  // the type's title
    const NodeType* type = nullptr;
    bool muted = false;
    bool reroute = false;
    ImVec2 at{0, 0}, size{0, 0};
    std::vector<Pin> pins;
    std::vector<Field> fields;
    std::vector<glm::dvec3> strip;  // of a color ramp: display colors from 0 to 1
    std::vector<double> values;     // of a curve: values from 0 to 1
    float more_y = -1;              // top of the row that shows all ports or fewer; -1: none
    std::string more;               // text of that row: "37 more inputs"
    bool unfolded = false;          // a long card with all ports
    float preview_y = -1;           // top of the node preview; -1: none
    // The header's texts as shown, truncated to fit; title may be "".
    std::string name, title;
    float name_width = 0;

    Extent extent() const { return {at, {at.x + size.x, at.y + size.y}}; }
    // Node id in a link to the card; "" for the outputs of the graph.
    std::string link_id() const { return kind == Kind::outputs ? "" : id; }
};
struct Wire : Connection {
    ImVec2 start{0, 0}, end{0, 0};  // canvas units
    PortType from_type = PortType::float_, to_type = PortType::float_;
    bool known = true;
    Conversion conversion = Conversion::same;
    uint32_t from_card = 0, to_card = 0;  // in Layout::cards

    bool ends_at(const Link& input) const { return node == input.node && port == input.port; }
    ImVec2 middle() const { return {(start.x + end.x) / 2, (start.y + end.y) / 2}; }
};

struct Layout {
    std::vector<Card> cards;  // in drawing order
    std::vector<Wire> wires;
    Extent bounds{{0, 0}, {0, 0}};
    std::vector<Extent> card_boxes, wire_boxes;  // canvas units; a card includes its pins

    const Card* find(std::string_view id, Card::Kind kind = Card::Kind::node) const;
    const Wire* wire_to(const Link& input) const;  // nullptr: none; O(wires)

    // Inputs of this layout, compared by the next update to rebuild only differing cards.
    Table<NodePtr> nodes;
    std::vector<uint32_t> card_of_node;  // by index in `nodes`
    std::vector<uint64_t> readers;       // by index in `nodes`: key of the outputs that are read
    uint64_t fonts = 0;                  // Fonts::generation()
    ImVec2 dragged{0, 0};                // offset of the dragged cards from their stored positions
    size_t made = 0;                     // cards of nodes built by the last update
};

// Result of a hit test under the pointer.
struct Hit {
    enum class Kind : uint8_t { nothing, card, header, pin, field, wire, more, box };
    static constexpr size_t no_card = ~size_t{0};
    Kind kind = Kind::nothing;
    size_t card = 0;    // in Layout::cards
    size_t part = 0;    // pin or field of the card; wire of the layout; box (canvas/boxes.h)
    uint8_t edges = 0;  // edges of a box, as bits: left 1, right 2, top 4, bottom 8

    bool on_card(const Layout& layout) const {  // or on a part of a card
        return kind != Kind::nothing && kind != Kind::wire && card < layout.cards.size();
    }
};

}  // namespace wrinkle::editor
