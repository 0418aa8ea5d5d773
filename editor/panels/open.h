// What is open over the panels: the palette, and a text or a list over a field.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "editor/canvas/gesture.h"
#include "registry/registry.h"

namespace wrinkle::editor {

// The search that adds a node, perhaps at the end of a wire.
struct Palette {
    bool open = false, opening = false;
    bool find = false;      // lists the nodes of the graph instead
    bool commands = false;  // lists commands instead
    ImVec2 at{0, 0};        // screen
    std::string query;
    int chosen = 0;
    int first = 0;              // row that is drawn
    bool all_types = false;     // not only those that fit the wire
    bool at_selection = false;  // the node goes in the selected wire or behind the selected nodes
    Gesture wire;               // kind wire: what it shall be connected to
};

// What was chosen lately, the newest first.
struct Recent {
    std::vector<std::string> nodes, commands;  // ids
};

// What could stand between the two ends of a wire that do not fit each other.
struct Offer {
    struct Choice {
        const NodeType* type = nullptr;
        std::string in, out;  // its ports in the wire
    };
    bool open = false, opening = false;
    ImVec2 at{0, 0};  // screen
    std::string why;  // one sentence
    std::vector<Choice> choices;
    int chosen = 0;
    // The ends of the wire; `lifted` is where it ended before, when it was taken off.
    Link from;
    std::string node, port;
    std::optional<Link> lifted;
};

// The text of a note or the title of a frame while it is edited.
struct BoxText {
    bool open = false, opening = false;
    BoxId box;
    std::string text;
    std::string merge;  // of the step that made the box
};

// A text or a list over a field or a header.
struct Popup {
    enum class Kind : uint8_t { none, text, rename, choice, file };
    Kind kind = Kind::none;
    bool opening = false;
    std::string node;
    uint32_t port_index = 0;
    int lane = 0;
    ImVec2 at{0, 0};
    float width = 0;
    std::string text;
    std::vector<std::string> files;  // of kind file, as they were when it opened
};

}  // namespace wrinkle::editor
