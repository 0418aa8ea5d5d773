// What the hand is doing on the canvas between the press of a button and its release.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/canvas/box_id.h"
#include "graph/document.h"
#include "registry/port_type.h"

namespace wrinkle::editor {

// What the hand is doing on the canvas; it owns the pointer until the button is up or Escape.
struct Gesture {
    enum class Kind : uint8_t {
        none,
        pan,
        box,
        move,
        wire,
        value,
        cut,      // a stroke across wires
        reroute,  // the same, for a reroute in each
        lazy,     // from a card to a card
        lasso,
        resize,  // of a frame or a note
    };
    Kind kind = Kind::none;
    int button = 0;
    ImVec2 start{0, 0};   // screen
    uint64_t serial = 0;  // of the document that it began with
    bool moved = false;
    bool panning = false;            // the view moves, as the pointer is at the border
    ImVec2 pan{0, 0};                // of the view, as it was
    std::set<std::string> selected;  // as it was
    std::set<BoxId> boxes;           // the selected ones, as they were

    // of a move
    ImVec2 offset{0, 0};            // canvas units
    std::set<std::string> carried;  // cards that go along
    std::set<BoxId> carried_boxes;
    std::optional<size_t> under_wire;  // of the layout: that the card would stand in

    // of a stroke
    struct Crossing {
        size_t wire = 0;  // of the layout
        ImVec2 at{0, 0};  // canvas units
    };
    std::vector<ImVec2> stroke;  // canvas units
    std::vector<Crossing> crossed;

    size_t card = 0;  // of the layout: where a lazy wire begins

    BoxId box;  // that was pressed
    uint8_t edges = 0;
    Rectangle rect;  // as it was

    // of a wire: its fixed end
    bool from_output = false;
    bool taken = false;  // it was lifted off node.port
    Link from;
    // The input that it was drawn from; with node "" an output of the graph.
    std::string node;
    std::string port;
    std::set<std::string> loops;  // nodes that it cannot go to without closing a cycle
    PortType type = PortType::float_;

    std::string merge;  // of the steps that this gesture makes

    // of a value
    uint32_t port_index = 0;
    int lane = 0;
    double start_value = 0;
    float width = 0;
};

}  // namespace wrinkle::editor
