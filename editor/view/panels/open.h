// State of the popups and dialogs over the panels: palette, browser, bake dialog, field editors.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "editor/model/bake/choices.h"
#include "editor/model/document/intent.h"
#include "editor/model/document/library.h"
#include "editor/model/document/wiring.h"
#include "editor/model/hosts/host_choices.h"
#include "editor/view/canvas/gesture.h"
#include "editor/view/panels/listing.h"
#include "registry/registry.h"

namespace wrinkle::editor {

// Search in a list: it adds a node, optionally at the end of a wire, shows a node, runs a command
// or returns to a step of the undo history.
struct Palette {
    enum class List : uint8_t { types, nodes, commands, steps };
    List list = List::types;
    bool open = false, opening = false;
    ImVec2 at{0, 0};  // screen
    std::string query;
    std::vector<std::string> graphs;    // files that can be sub-graphs, as written in the graph
    std::vector<LibraryEntry> library;  // other graphs, which are copied first
    int chosen = 0;
    int first = 0;              // first row that is drawn
    bool all_types = false;     // also types that do not fit the wire
    bool at_selection = false;  // insert into the selected wire or after the selected nodes
    Gesture wire;               // if its kind is wire: the wire to connect to the new node
};

// State of the file browser.
struct Browser {
    enum class Purpose : uint8_t {
        none,
        open_graph,
        save_graph,
        export_text,
        export_image,
        image,
        bake_mesh,
        bake_into,  // a folder, or a file
        host_mesh,
        host_into,  // a folder
        preview_mesh,
        preview_light
    };
    Purpose purpose = Purpose::none;
    std::filesystem::path folder;
    Listing listing;
    std::vector<size_t> shown;  // indices into listing.entries, as filtered
    int chosen = 0;             // index into `shown`
    std::string text, filtered_by;
    bool focus = false, scroll = false;
    std::string node, port;  // purpose `image`; "" adds a node
    size_t size = 0;         // purpose `export_image`: index into image_sizes()
    PendingAction then;      // action after the graph is saved
    std::string error_text;  // why the last answer failed
};

// State of the bake dialog.
struct BakeDialog {
    bool open = false, opening = false;
    BakeChoices choices;
    std::string replaces;  // one sentence on the files that would be overwritten
};

// State of the dialog of an export to a host.
struct HostDialog {
    bool open = false, opening = false;
    HostChoices choices;
    bool repeat = false;  // at every save
};

// Graph on the start page.
struct Sample {
    std::filesystem::path file;
    std::filesystem::path image;  // small image of its result; may not exist; "": is drawn
    std::string name;             // name of the graph; if it has none, of the file
    size_t nodes = 0;
    const Registry* registry = nullptr;  // to draw the image
};

// Start page, drawn in place of the canvas while there is no graph.
struct Start {
    bool left = false;  // the user requested an empty graph
    bool read = false;
    std::vector<Sample> library, materials, techniques;
};

// Help window: the page of a node's type, or the list of shortcuts.
struct Help {
    bool open = false, opening = false;
    std::string node, type;  // "" for the shortcuts
    float rested = 0;        // seconds since the pointer moved
    bool waiting = false;    // a tooltip is due when the pointer has rested long enough
};

// Menu of a part of the canvas, opened by the right button (panels/context_menu.cpp).
struct ContextMenu {
    enum class Part : uint8_t { card, wire, box };
    bool open = false, opening = false;
    ImVec2 at{0, 0};  // screen
    Part part = Part::card;
    // The node and its input under the pointer, or the input end of the wire; node "": an output of
    // the graph; port "": none.
    std::string node = {}, port = {};
    BoxId box = {};
    int chosen = 0;
};

// State of the panel of the graph's inputs; PreviewRequest has the chosen preset.
struct InputsPanel {
    bool shown = false;                // instead of the code
    bool lists_presets = false;        // the list of presets was open in the last frame
    std::string merge;                 // merge key of the undo steps of the control in use
    std::string text;                  // content of the open text field
    std::string name;                  // content of the field of the input's name
    std::vector<std::string> details;  // contents of the other fields of the menu
    // Input with a label that is dragged, "": none; and the input that it takes the position of.
    std::string carried, carried_to;
    bool carry_left = false;  // Escape ended the drag, and the button is still down
};

// State of the list of problems.
struct Problems {
    size_t current = 0;    // index of the problem shown last
    bool visited = false;  // a problem has been shown
    bool scroll = false;
};

// Recently used items, newest first.
struct Recent {
    std::vector<std::string> nodes, commands;  // ids
};

// Node types to insert between the two ends of a wire with incompatible types.
struct Offer {
    struct Choice {
        const NodeType* type = nullptr;
        std::string in, out;  // its ports for the wire
    };
    bool open = false, opening = false;
    ImVec2 at{0, 0};  // screen
    std::string why;  // one sentence
    std::vector<Choice> choices;
    int chosen = 0;
    Connection connection;       // the wire
    std::optional<Link> lifted;  // the input that it was disconnected from
};

// Editor for the text of a note or the title of a frame.
struct BoxText {
    bool open = false, opening = false;
    BoxId box;
    std::string text;
    std::string merge;  // merge key of the undo step that created the box
};

// Eyedropper of the color picker (panels/color_picker.cpp).
struct Eyedropper {
    bool on = false;     // in the last frame
    bool drawn = false;  // in the frame being drawn
    // Display color of the pixel under the pointer in the last frame; set by the window.
    std::optional<std::array<float, 3>> pixel;
};

// Text field, list or color picker over a field or a header.
struct Popup {
    enum class Kind : uint8_t { none, text, rename, choice, file, color, expose, ramp, curve };
    Kind kind = Kind::none;
    bool opening = false;
    std::string node = {};
    uint32_t port_index = 0;
    int lane = 0;
    size_t knot = 0;  // for kinds ramp and curve: index of the selected stop or point
    ImVec2 at{0, 0};
    float width = 0;
    ImVec2 size{0, 0};  // in the last frame
    std::string text = {};
    std::vector<std::string> files = {};  // for kind file: listed when the popup opened
    std::string query = {};               // filters a list
    int chosen = 0;                       // index into the filtered list
    int next = 0;                         // next field to open: 1 (Tab), -1 (Shift+Tab), 0: none
    std::string merge = {};  // merge key of the undo steps of an edit in several frames
};

}  // namespace wrinkle::editor
