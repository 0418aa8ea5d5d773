// What is open over the panels: the palette, and a text or a list over a field.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/bake/choices.h"
#include "editor/canvas/gesture.h"
#include "editor/document/intent.h"
#include "editor/panels/listing.h"
#include "editor/panels/samples.h"
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

// The file browser.
struct Browser {
    enum class Purpose : uint8_t {
        none,
        open_graph,
        save_graph,
        export_text,
        export_picture,
        picture,
        bake_mesh,
        bake_into  // a folder, or a file
    };
    Purpose purpose = Purpose::none;
    std::filesystem::path folder;
    Listing listing;
    std::vector<size_t> shown;  // of the listing's entries
    int chosen = 0;             // of those
    std::string text, filtered_by;
    bool focus = false, scroll = false;
    std::string node, port;  // of picture; "" adds a node
    size_t size = 0;         // of export_picture: one of picture_sizes()
    Intent then;             // what follows once the graph is saved
    std::string trouble;     // why the last answer could not be followed
};

// Maps to bake are being chosen.
struct BakeDialog {
    bool open = false, opening = false;
    BakeChoices choices;
    std::optional<BakeChoices> looked;  // for which `replaces` was found
    std::string replaces;               // which files are there already, one sentence
};

// The page that stands in for a canvas without a graph.
struct Start {
    bool left = false;  // an empty graph was asked for
    bool read = false;
    std::vector<Sample> samples;
};

// The page of a node's type, or the list of shortcuts.
struct Help {
    bool open = false, opening = false;
    std::string node, type;  // "" for the shortcuts
    float rested = 0;        // seconds that the pointer has not moved
    bool waiting = false;    // for the pointer to have rested long enough
};

// The list of problems.
struct Problems {
    size_t current = 0;    // the one that was shown last
    bool visited = false;  // any was
    bool scroll = false;
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
    enum class Kind : uint8_t { none, text, rename, choice, file, color };
    Kind kind = Kind::none;
    bool opening = false;
    std::string node;
    uint32_t port_index = 0;
    int lane = 0;
    ImVec2 at{0, 0};
    float width = 0;
    std::string text;
    std::vector<std::string> files;  // of kind file, as they were when it opened
    std::string query;               // narrows a list
    int chosen = 0;                  // of what is left of it
    int next = 0;                    // 1 or -1: Tab asked for the next or the last field
    std::string merge;               // of the steps that a colour makes
};

}  // namespace wrinkle::editor
