// Pointer gesture on the canvas, from the press of a button to its release.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/model/document/boxes.h"
#include "graph/document.h"
#include "registry/port_type.h"

namespace wrinkle::editor {

// The gesture in progress; it captures the pointer until the button is released or Escape is
// pressed.
struct Gesture {
    enum class Kind : uint8_t {
        none,
        pan,
        box,
        move,
        wire,
        value,
        cut,      // a stroke across wires
        reroute,  // a stroke; inserts a reroute in each crossed wire
        lazy,     // a wire from card to card
        lasso,
        resize,  // resizes a frame or a note
    };
    Kind kind = Kind::none;
    int button = 0;       // ImGuiMouseButton
    ImVec2 start{0, 0};   // screen
    uint64_t serial = 0;  // history serial at the start
    bool moved = false;
    bool panning = false;            // the view moves because the pointer is near the border
    ImVec2 pan{0, 0};                // View::pan at the start
    std::set<std::string> selected;  // selected nodes at the start
    std::set<BoxId> boxes;           // selected boxes at the start

    // Move.
    ImVec2 offset{0, 0};            // canvas units
    std::set<std::string> carried;  // cards that move along
    std::set<BoxId> carried_boxes;
    std::optional<size_t> under_wire;  // in Layout::wires; the card would be inserted in it

    // Cut, reroute, lasso.
    struct Crossing {
        size_t wire = 0;  // in Layout::wires
        ImVec2 at{0, 0};  // canvas units
    };
    std::vector<ImVec2> stroke;  // canvas units
    std::vector<Crossing> crossed;

    size_t card = 0;  // in Layout::cards; start of a lazy wire

    BoxId box;          // the pressed box
    uint8_t edges = 0;  // dragged edges: 1 left, 2 right, 4 top, 8 bottom
    Rectangle rect;     // at the start

    // Wire: its fixed end.
    bool from_output = false;
    bool taken = false;  // the drag detached the wire from node.port
    Link from;
    // The input at which the drag began; an empty `node` means an output of the graph.
    std::string node;
    std::string port;
    std::set<std::string> loops;  // nodes that would close a cycle
    PortType type = PortType::float_;

    std::string merge;  // merge key of this gesture's history steps

    // Value.
    uint32_t port_index = 0;
    int lane = 0;                          // component of the value
    bool drags = true;                     // a drag changes the value
    std::array<double, 4> start_values{};  // of all lanes
    float width = 0;                       // width of the field, in screen pixels
};

}  // namespace wrinkle::editor
