// A graph file as a value: what it says, in its order, and where it said it.
//
// A Document is an immutable snapshot, cheap to copy: the parts of two copies are shared, a node is
// one shared_ptr, and an edit (graph/edit.h: Document -> Document) replaces only what it changes,
// so two snapshots are compared by pointer. It knows no node types: ports, literal values and types
// are taken as written and checked in core/lower. What the format does not know is kept verbatim.
//
// Positions are those of the text as read: a thing that was edited has none of its own and is
// reported at its node, else at the file. JSON pointers follow the present names.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/back_faces.h"
#include "base/diagnostics.h"
#include "graph/table.h"
#include "json/value.h"

namespace wrinkle {

// "weave.gradient": an output of a node, a property of the surface or an input of the graph.
struct Link {
    static constexpr std::string_view surface = "surface";
    static constexpr std::string_view input = "input";

    std::string node;  // a node's id, or one of the two words above
    std::string port;

    bool is_surface() const { return node == surface; }
    bool is_input() const { return node == input; }
    bool is_node() const { return !node.empty() && !is_surface() && !is_input(); }
    std::string text() const { return node + "." + port; }
    bool operator==(const Link&) const = default;
};

// A key that the format does not know, or a known one with a value of the wrong kind (already
// reported), kept as it was.
struct Extra {
    std::string key;
    json::Value value;
};

// What stands at a port in a node's "in".
struct Input {
    enum class Kind : uint8_t {
        literal,  // `value` is the literal
        link,     // `link` says whence; `value` is the {"from": ...} object
        broken,   // looks like a link but is none, already reported; `value` as it was
    };
    std::string port;
    Kind kind = Kind::literal;
    Link link;
    json::Value value;
};

struct Node {
    std::string id;
    std::string type;  // "" when it is missing, already reported
    int version = 1;
    bool muted = false;
    std::vector<Input> inputs;  // in file order, each port once
    std::vector<Extra> unknown;
    json::Value source;  // its JSON as it was read; written back as it was if it is no object

    const Input* find(std::string_view port) const;
    // The file of a sub-graph, "weave.json" of "graph:weave.json"; nothing for another type.
    std::optional<std::string_view> subgraph() const;
};
using NodePtr = std::shared_ptr<const Node>;
inline std::string_view table_key(const NodePtr& node) {
    return node->id;
}

// An input of the whole graph, read by nodes as {"from": "input.NAME"}.
struct GraphInput {
    std::string name;
    std::string type;           // a type on wires (docs/graph-format.md), unchecked
    json::Value default_value;  // null when absent
    std::string doc;
    std::vector<Extra> unknown;
    json::Value source;
};
inline std::string_view table_key(const GraphInput& input) {
    return input.name;
}

struct Output {
    std::string name;
    Input from;  // `port` is the output's name; anything but a link is reported and kept as broken
};
inline std::string_view table_key(const Output& output) {
    return output.name;
}

// Layout, in canvas units, y down. Numbers that were not edited keep their spelling in `source`.
struct Position {
    std::string id;  // of a node; may be that of none
    double x = 0, y = 0;
    json::Value source;
};
struct Rectangle {
    double x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Rectangle&) const = default;
};
// {"title": "Rust", "rect": [x, y, width, height]} under "$frames"; a note has "text" in place of
// "title" and stands under "$notes". Other keys are kept.
struct Box {
    std::string id;
    std::string text;
    Rectangle rect;
    std::vector<Extra> unknown;
    json::Value source;
};
inline std::string_view table_key(const Position& position) {
    return position.id;
}
inline std::string_view table_key(const Box& box) {
    return box.id;
}

class Wires;

struct Document {
    std::string file;  // as given to read_document; "" for a new one
    std::string name;
    BackFaces back_faces = BackFaces::mirror;
    Table<NodePtr> nodes;  // in file order
    Table<GraphInput> inputs;
    Table<Output> outputs;
    Table<Position> positions;
    Table<Box> frames;
    Table<Box> notes;
    std::vector<Extra> unknown_layout;        // entries of "layout" of another shape
    std::vector<Extra> unknown;               // top-level keys
    json::Value source;                       // the whole as it was read; null for a new one
    bool edited = false;                      // set by every edit that changes something
    std::shared_ptr<const Wires> read_wires;  // as read; null: check_links found something
    // Why not all of the text is in here, a clause or a problem: writing it would lose the rest.
    std::string lost;

    const Node* find(std::string_view id) const;
    // Where all of them hold and nothing was edited, else null.
    const Wires* wires() const { return edited ? nullptr : read_wires.get(); }
};

// A Diagnostic at a thing of the document: its file, line, column, pointer and node are filled in.
Diagnostic diagnose(const Document&, std::string message, std::string expected = {});
Diagnostic diagnose(const Document&, const Node&, std::string message, std::string expected = {});
// At a port's value; at the node when the port is not written. `node.inputs` need not have it.
Diagnostic diagnose_port(const Document&, const Node&, std::string_view port, std::string message,
                         std::string expected = {});
Diagnostic diagnose(const Document&, const GraphInput&, std::string message,
                    std::string expected = {});
Diagnostic diagnose(const Document&, const Output&, std::string message, std::string expected = {});
// At a value inside any of them, such as one key of an image; `node` may be "".
Diagnostic diagnose(const json::Value&, std::string node, std::string message,
                    std::string expected = {});

// Why a text cannot be a node's id, "" when it can; 1 to 128 characters of UTF-8, no dot, no
// control character, not beginning with '$', not "surface" or "input". Names of graph inputs and
// outputs follow the same rule, but may be those two words (`reserved` = false).
std::string id_problem(std::string_view id, bool reserved = true);

}  // namespace wrinkle
