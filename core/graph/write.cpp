#include "graph/write.h"

#include "base/text.h"
#include "json/write.h"

namespace wrinkle {
namespace {

using json::Kind;
using json::one_line;
using json::Value;

// Writes the members of one object, each on its own line.
class Block {
public:
    Block(std::string& out, size_t indent) : out_(out), indent_(indent) { out_ += '{'; }
    // Continues an object that is already open; `empty`: it has no members yet.
    Block(std::string& out, size_t indent, bool empty)
        : out_(out), indent_(indent), empty_(empty) {}

    // Begins a member; the caller appends its value.
    std::string& key(std::string_view name) {
        out_ += empty_ ? "\n" : ",\n";
        empty_ = false;
        out_.append(indent_, ' ');
        out_ += json_quoted(name);
        out_ += ": ";
        return out_;
    }
    void verbatim(const std::vector<Extra>& extras) {
        for (const Extra& extra : extras)
            verbatim(extra);
    }
    void verbatim(const Extra& extra) {
        key(extra.key) += json::pretty(extra.value, indent_, indent_ + extra.key.size() + 4);
    }
    void close() {
        if (!empty_) {
            out_ += '\n';
            out_.append(indent_ - 2, ' ');
        }
        out_ += '}';
    }

private:
    std::string& out_;
    size_t indent_;
    bool empty_ = true;
};

bool has(const std::vector<Extra>& extras, std::string_view key) {
    for (const Extra& extra : extras)
        if (extra.key == key) return true;
    return false;
}

bool is_kept_whole(const Value& source) {
    return source.has_location() && !source.is(Kind::object);
}

// Returns those of "type", "version" and "muted" that are written.
std::vector<std::pair<const char*, std::string>> head(const Node& node) {
    std::vector<std::pair<const char*, std::string>> members;
    if (!has(node.unknown, "type") && !node.type.empty())
        members.emplace_back("type", json_quoted(node.type));
    if (node.version > 1) members.emplace_back("version", std::to_string(node.version));
    if (node.muted) members.emplace_back("muted", "true");
    return members;
}

std::string node_line(const Node& node) {
    std::string inputs;
    for (const Input& input : node.inputs)
        inputs +=
            (inputs.empty() ? "" : ", ") + json_quoted(input.port) + ": " + one_line(input.value);
    std::string text;
    for (const auto& [key, value] : head(node))
        text += (text.empty() ? "\"" : ", \"") + std::string(key) + "\": " + value;
    if (!inputs.empty()) text += (text.empty() ? "" : ", ") + ("\"in\": { " + inputs) + " }";
    return text.empty() ? "{}" : "{ " + text + " }";
}

void write_node(std::string& out, const Node& node) {
    constexpr size_t max_on_one_line = 2;
    if (is_kept_whole(node.source)) {
        out += one_line(node.source);
        return;
    }
    if (node.inputs.size() <= max_on_one_line && node.unknown.empty()) {
        out += node_line(node);
        return;
    }
    Block block(out, 6);
    for (const auto& [key, value] : head(node))
        block.key(key) += value;
    if (!node.inputs.empty()) {
        Block in(block.key("in"), 8);
        for (const Input& input : node.inputs)
            in.key(input.port) += one_line(input.value);
        in.close();
    }
    block.verbatim(node.unknown);
    block.close();
}

Value graph_input_value(const GraphInput& input) {
    std::vector<std::pair<std::string, Value>> members;
    if (!input.type.empty()) members.emplace_back("type", Value::string(input.type));
    if (!input.default_value.is(Kind::null)) members.emplace_back("default", input.default_value);
    if (!input.doc.empty()) members.emplace_back("doc", Value::string(input.doc));
    for (const Extra& extra : input.unknown)
        members.emplace_back(extra.key, extra.value);
    return Value::object(members);
}

// Returns an array of these numbers; a number equal to that of `old` at its index retains its
// spelling.
Value number_array(std::initializer_list<double> numbers, const Value& old) {
    std::vector<Value> items;
    for (const double number : numbers) {
        const size_t i = items.size();
        const bool had = old.is(Kind::array) && i < old.size() && old.at(i).is(Kind::number);
        const bool keep = had && old.at(i).as_number() == number;
        items.push_back(keep ? old.at(i) : Value::number(number));
    }
    return Value::array(items);
}

// Returns the JSON of a frame (text key "title") or note ("text").
Value box_value(const Box& box, std::string_view text_key) {
    std::vector<std::pair<std::string, Value>> members;
    if (!box.text.empty()) members.emplace_back(text_key, Value::string(box.text));
    if (!has(box.unknown, "rect"))
        members.emplace_back("rect",
                             number_array({box.rect.x, box.rect.y, box.rect.width, box.rect.height},
                                          box.source.find("rect")));
    for (const Extra& extra : box.unknown)
        members.emplace_back(extra.key, extra.value);
    return Value::object(members);
}

void write_boxes(Block& layout, const char* name, const Table<Box>& boxes, const char* text_key) {
    if (boxes.empty()) return;
    Block block(layout.key(name), 6);
    for (const Box& box : boxes)
        block.key(box.id) +=
            one_line(is_kept_whole(box.source) ? box.source : box_value(box, text_key));
    block.close();
}

bool has_layout(const Document& document) {
    return !document.positions.empty() || !document.frames.empty() || !document.notes.empty() ||
           !document.unknown_layout.empty();
}

void write_head(Block& top, const Document& document) {
    for (const Extra& extra : document.unknown)
        if (extra.key == "$schema") top.verbatim(extra);
    if (!has(document.unknown, "wrinkle")) top.key("wrinkle") += "1";
    if (!document.name.empty()) top.key("name") += json_quoted(document.name);
    if (document.back_faces)
        top.key("back_faces") +=
            json_quoted(back_faces_names[static_cast<size_t>(*document.back_faces)]);
    if (document.inputs.empty()) return;
    Block block(top.key("inputs"), 4);
    for (const GraphInput& input : document.inputs)
        block.key(input.name) +=
            one_line(is_kept_whole(input.source) ? input.source : graph_input_value(input));
    block.close();
}

}  // namespace

std::string write_document(const Document& document) {
    if (!document.edited && document.source.has_location())
        return std::string(document.source.source());
    return canonical_text(document);
}

std::string canonical_text(const Document& document) {
    const CanonicalParts parts{document};
    std::string out = parts.head();
    if (parts.has_node_parts())
        for (size_t i = 0; i < document.nodes.size(); ++i)
            out += CanonicalParts::node(*document.nodes[i], i == 0);
    out += parts.middle(out.size() == 1);
    for (size_t i = 0; i < document.positions.size(); ++i)
        out += CanonicalParts::position(document.positions[i], i == 0);
    return out + parts.end(out.size() == 1);
}

bool CanonicalParts::has_node_parts() const {
    return !has(document.unknown, "nodes");
}

std::string CanonicalParts::head() const {
    std::string out;
    Block top(out, 2);
    write_head(top, document);
    if (has_node_parts()) top.key("nodes") += '{';
    return out;
}

std::string CanonicalParts::node(const Node& node, bool first) {
    std::string out;
    write_node(Block(out, 4, first).key(node.id), node);
    return out;
}

std::string CanonicalParts::middle(bool first) const {
    std::string out;
    if (has_node_parts()) Block(out, 4, document.nodes.empty()).close();
    Block top(out, 2, first);
    if (!has(document.unknown, "outputs")) {
        Block outputs(top.key("outputs"), 4);
        for (const Output& output : document.outputs)
            outputs.key(output.name) += one_line(output.from.value);
        outputs.close();
    }
    if (has_layout(document)) top.key("layout") += '{';
    return out;
}

std::string CanonicalParts::position(const Position& position, bool first) {
    std::string out;
    Block(out, 4, first).key(position.id) +=
        one_line(number_array({position.x, position.y}, position.source));
    return out;
}

std::string CanonicalParts::end(bool first) const {
    std::string out;
    if (has_layout(document)) {
        Block layout(out, 4, document.positions.empty());
        write_boxes(layout, "$frames", document.frames, "title");
        write_boxes(layout, "$notes", document.notes, "text");
        layout.verbatim(document.unknown_layout);
        layout.close();
    }
    Block top(out, 2, first);
    for (const Extra& extra : document.unknown)
        if (extra.key != "$schema") top.verbatim(extra);
    top.close();
    return out + "\n";
}

}  // namespace wrinkle
