// All that the editor knows. Panels are free functions over it.
//
// The document is a snapshot in `history`; everything else is view (never saved in the graph, never
// undone) or follows from the document (`model`, `built`), brought up to date by refresh().
#pragma once

#include <imgui.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editor/fonts.h"
#include "editor/history.h"
#include "editor/model.h"
#include "editor/preview.h"
#include "editor/targets.h"

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

// What the hand is doing on the canvas; it owns the pointer until the button is up or Escape.
struct Gesture {
    enum class Kind : uint8_t { none, pan, box, move, wire, value };
    Kind kind = Kind::none;
    ImVec2 start{0, 0};  // screen
    bool moved = false;
    ImVec2 offset{0, 0};  // of a move, canvas units

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

// The search that adds a node, perhaps at the end of a wire.
struct Palette {
    bool open = false, opening = false;
    bool commands = false;  // lists commands instead
    ImVec2 at{0, 0};        // screen
    std::string query;
    int chosen = 0;
    Gesture wire;  // kind wire: what it shall be connected to
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

struct View {
    ImVec2 pan{0, 0};  // screen pixels from the canvas's corner to the canvas origin
    float zoom = 1;
    bool fitted = false;
    ImVec2 corner{0, 0}, extent{0, 0};  // the canvas on the screen
    std::set<std::string> selected;
    std::vector<std::string> order;  // raised nodes, the topmost last
    // Where the cards at the borders stand, once they have been put somewhere; canvas units.
    std::optional<ImVec2> surface_at, outputs_at;
    std::optional<Link> selected_wire;  // by its reading end; node "" is an output of the graph
    bool all_surface = false, all_outputs = false;
    bool code_baked = false;
    int code_hovered = -1;
    float side = 0.30F;     // of the window's width
    float preview = 0.53F;  // of the side column's height
    PreviewView preview_view;
};

struct Counters {
    uint64_t builds = 0;    // texts generated
    uint64_t uniforms = 0;  // values sent to the running material
};

struct State {
    const Registry* registry = nullptr;
    Fonts fonts;
    History history;
    std::filesystem::path path;
    uint64_t saved_serial = 0;
    std::string save_refused;  // why this file is not written: what reading it would lose
    bool quit = false, quit_asked = false;

    View view;
    Gesture gesture;
    Hit hovered;
    Palette palette;
    Popup popup;
    std::string status;  // what the last action did, or why it was refused

    Model model;
    Build built;
    Document built_of;
    Document sent;       // whose values the preview shows
    bool fresh = false;  // model and build exist
    Layout layout;
    Document layout_of;
    bool layout_stale = true;

    Preview* preview = nullptr;  // nullptr without GL
    Diagnostics preview_problems;
    bool preview_stale = false;
    Counters counters;
    Targets targets;

    const Document& document() const { return history.now(); }
    bool dirty() const { return history.serial() != saved_serial; }
    std::filesystem::path folder() const;
    std::string title() const;  // of the window
    const NodeType* type_of(std::string_view node) const { return model.type_of(node); }

    // One step of history; says so in the status.
    void commit(std::string name, Document document, const std::string& merge = {});
};

// Opens a graph. A file that does not exist is a new graph under that name.
void open_file(State& state, const std::filesystem::path& path);
bool save_file(State& state);

// Brings model, build and preview up to the present snapshot, doing no more than changed.
void refresh(State& state);

}  // namespace wrinkle::editor
