// Document: the contents of a graph file, in file order, with source locations.
//
// A Document is an immutable snapshot, cheap to copy: two copies share their parts, each node is a
// shared_ptr, and an edit (graph/edit.h: Document -> Document) replaces only the parts that it
// changes, so snapshots are compared by pointer. It does not know node types: ports, literal values
// and types are stored as written and checked in core/lower. Unknown keys are stored verbatim.
// Locations refer to the text as read: an edited part has no location and is reported at its node,
// else at the file. JSON pointers into an edited document use the current names.
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

// Reference to an output of a node ("weave.gradient"), a surface property or a graph input.
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

// A key that the format does not define, or a known key with a value of the wrong kind (already
// reported), stored verbatim.
struct Extra {
    std::string key;
    json::Value value;
};

// Value of one port in a node's "in".
struct Input {
    enum class Kind : uint8_t {
        literal,  // `value` is the literal
        link,     // `link` is the source; `value` is the {"from": ...} object
        broken,   // has "from" but is not a valid link, already reported; `value` as read
    };
    std::string port;
    Kind kind = Kind::literal;
    Link link;
    json::Value value;
};

// The type of a node that is a sub-graph: "graph:weave.json" for the file "weave.json".
std::string type_of_subgraph(std::string_view file);
// Returns the file; std::nullopt for other types.
std::optional<std::string_view> subgraph_file(std::string_view type);

struct Node {
    std::string id;
    std::string type;  // "" if missing, already reported
    int version = 1;
    bool muted = false;
    std::vector<Input> inputs;  // in file order, each port once
    std::vector<Extra> unknown;
    json::Value source;  // JSON as read; written back verbatim if it is not an object

    const Input* find(std::string_view port) const;
    std::optional<std::string_view> subgraph() const { return subgraph_file(type); }
};
using NodePtr = std::shared_ptr<const Node>;
inline std::string_view table_key(const NodePtr& node) {
    return node->id;
}

// Two numbers, the lesser first.
struct Range {
    double least = 0, most = 0;
};

// An input of the graph, read by nodes as {"from": "input.NAME"}. Absent values are null, absent
// texts "". Only the shapes of the values are checked.
struct GraphInput {
    std::string name;
    std::string type;           // port type (docs/graph-format.md), unchecked
    json::Value default_value;  // unchecked
    json::Value choices;        // array of names
    json::Value slider;         // range of a control: [0, 1]
    json::Value limits;         // values outside are clamped
    json::Value step;           // step of a control, greater than 0
    std::string unit;
    std::string label;   // displayed instead of the name
    std::string group;   // "Wear/Edges"
    std::string widget;  // name of a control, unchecked
    std::string when;    // condition of display (graph/condition.h), unchecked
    std::string doc;
    json::Value renamed;  // array of former names (graph/renamed.h)
    std::vector<Extra> unknown;
    json::Value source;
};
inline std::string_view table_key(const GraphInput& input) {
    return input.name;
}

// Calls visit(key, value) for each key of a graph input, in the order of canonical text.
template <class AnyInput, class Visit>
void each_key(AnyInput& input, Visit visit) {
    visit("type", input.type);
    visit("default", input.default_value);
    visit("choices", input.choices);
    visit("slider", input.slider);
    visit("limits", input.limits);
    visit("step", input.step);
    visit("unit", input.unit);
    visit("label", input.label);
    visit("group", input.group);
    visit("widget", input.widget);
    visit("when", input.when);
    visit("doc", input.doc);
    visit("renamed", input.renamed);
}

// Returns the keys that are present, in the same order.
std::vector<Extra> present_keys(const GraphInput& input);

// Returns the range of a slider or limits; std::nullopt if it is absent.
std::optional<Range> range_of(const json::Value& pair);

// Values of the graph's inputs under one name; inputs that it does not name have their defaults.
struct Preset {
    std::string name;
    std::vector<Extra> values;  // by name of the input, each once, unchecked
    json::Value source;
};
inline std::string_view table_key(const Preset& preset) {
    return preset.name;
}

struct Output {
    std::string name;
    Input from;  // `port` is the output name; a non-link value is reported and stored as broken
};
inline std::string_view table_key(const Output& output) {
    return output.name;
}

// Layout, in canvas units, y down. Unedited numbers are written with the spelling in `source`.
struct Position {
    std::string id;  // node id; the node need not exist
    double x = 0, y = 0;
    json::Value source;
};
struct Rectangle {
    double x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Rectangle&) const = default;
};
// {"title": "Rust", "rect": [x, y, width, height]} in "$frames"; a note is in "$notes" and has
// "text" instead of "title". Other keys are preserved.
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
    std::string file;  // as given to read_document; "" for a new document
    std::string name;
    std::optional<BackFaces> back_faces;  // unset: `mirror`
    Table<NodePtr> nodes;                 // in file order
    Table<GraphInput> inputs;
    Table<Preset> presets;
    Table<Output> outputs;
    Table<Position> positions;
    Table<Box> frames;
    Table<Box> notes;
    std::vector<Extra> unknown_layout;        // entries of "layout" with another shape
    std::vector<Extra> unknown;               // top-level keys
    json::Value source;                       // the root as read; null for a new document
    bool edited = false;                      // set by every edit that changes something
    std::shared_ptr<const Wires> read_wires;  // as read; null if incomplete or with link errors
    // Reason why part of the text was not read, a clause or the first error as a line; saving would
    // lose that part. "": all was read.
    std::string lost;

    const Node* find(std::string_view id) const;
    // Returns the first output of this name or of a synonym (base/standard_outputs.h).
    const Output* find_output(std::string_view name) const;
    BackFaces back_face_rule() const { return back_faces.value_or(BackFaces::mirror); }
    // Returns the wires as read if all are valid and nothing was edited, else null.
    const Wires* wires() const { return edited ? nullptr : read_wires.get(); }
};

// Diagnostic about a part of the document, with its file, line, column, pointer and node.
Diagnostic diagnose(const Document&, RuleId rule, std::string message, std::string expected = {});
Diagnostic diagnose(const Document&, const Node&, RuleId rule, std::string message,
                    std::string expected = {});
// Located at a port's value; at the node if the port is not written. `node.inputs` may lack the
// port.
Diagnostic diagnose_port(const Document&, const Node&, std::string_view port, RuleId rule,
                         std::string message, std::string expected = {});
Diagnostic diagnose(const Document&, const GraphInput&, RuleId rule, std::string message,
                    std::string expected = {});
// Located at the value of one of its keys; at the input if the key is not written.
Diagnostic diagnose_key(const Document&, const GraphInput&, std::string_view key, RuleId rule,
                        std::string message, std::string expected = {});
Diagnostic diagnose(const Document&, const Output&, RuleId rule, std::string message,
                    std::string expected = {});
// Located at a value inside any of them, such as one key of an image; `node` may be "".
Diagnostic diagnose(const json::Value&, std::string node, RuleId rule, std::string message,
                    std::string expected = {});

// Returns the reason why a text cannot be a node id, "" if it can. A valid id is 1 to 128
// characters of UTF-8 without a dot or control character, does not begin with '$', and is not
// "surface" or "input". Names of graph inputs and outputs follow the same rule, but may be those
// two words (`reserved` = false).
std::string id_problem(std::string_view id, bool reserved = true);

}  // namespace wrinkle
