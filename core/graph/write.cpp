#include "graph/write.h"

#include <algorithm>

#include "base/text.h"
#include "json/write.h"

namespace wrinkle {
namespace {

using json::Kind;
using json::one_line;
using json::Value;

// Writes the members of one object, each on its own line, or all on one line.
class Block {
public:
    static constexpr size_t flat = 0;  // instead of an indentation

    Block(std::string& out, size_t indent) : out_(out), indent_(indent) { out_ += '{'; }

    // Begins a member; the caller appends its value.
    std::string& key(std::string_view name) {
        if (!empty_) out_ += ',';
        empty_ = false;
        new_line(indent_);
        out_ += json_quoted(name);
        out_ += ": ";
        return out_;
    }
    void verbatim(const std::vector<Extra>& extras) {
        for (const Extra& extra : extras)
            verbatim(extra);
    }
    void verbatim(const Extra& extra) {
        key(extra.key) += indent_ == flat
                              ? one_line(extra.value)
                              : json::pretty(extra.value, indent_, indent_ + extra.key.size() + 4);
    }
    void close() {
        if (!empty_) new_line(indent_ - 2);
        out_ += '}';
    }

private:
    void new_line(size_t indent) {
        out_ += indent_ == flat ? ' ' : '\n';
        if (indent_ != flat) out_.append(indent, ' ');
    }

    std::string& out_;
    size_t indent_;
    bool empty_ = true;
};

bool has(const std::vector<Extra>& extras, std::string_view key) {
    return std::ranges::find(extras, key, &Extra::key) != extras.end();
}

// Writes the source as it was read if it is not an object; returns false otherwise.
bool write_whole(std::string& out, const Value& source) {
    const bool whole = source.has_location() && !source.is(Kind::object);
    if (whole) out += one_line(source);
    return whole;
}

void write_node(std::string& out, const Node& node) {
    constexpr size_t max_on_one_line = 2;
    if (write_whole(out, node.source)) return;
    const bool flat = node.inputs.size() <= max_on_one_line && node.unknown.empty();
    Block block(out, flat ? Block::flat : 6);
    if (!has(node.unknown, "type") && !node.type.empty())
        block.key("type") += json_quoted(node.type);
    if (node.version > 1) block.key("version") += std::to_string(node.version);
    if (node.muted) block.key("muted") += "true";
    if (!node.inputs.empty()) {
        Block in(block.key("in"), flat ? Block::flat : 8);
        for (const Input& input : node.inputs)
            in.key(input.port) += one_line(input.value);
        in.close();
    }
    block.verbatim(node.unknown);
    block.close();
}

void write_graph_input(std::string& out, const GraphInput& input) {
    constexpr size_t max_on_one_line = 4;
    if (write_whole(out, input.source)) return;
    const std::vector<Extra> keys = present_keys(input);
    const bool flat = keys.size() + input.unknown.size() <= max_on_one_line;
    Block block(out, flat ? Block::flat : 6);
    for (const Extra& key : keys)
        block.key(key.key) += one_line(key.value);
    block.verbatim(input.unknown);
    block.close();
}

void write_preset(std::string& out, const Preset& preset) {
    constexpr size_t max_on_one_line = 4;
    if (write_whole(out, preset.source)) return;
    Block block(out, preset.values.size() <= max_on_one_line ? Block::flat : 6);
    for (const Extra& value : preset.values)
        block.key(value.key) += one_line(value.value);
    block.close();
}

// Writes a section of named entries, each by `write`; nothing without entries.
template <class T>
void write_table(Block& top, std::string_view name, const Table<T>& entries,
                 void (*write)(std::string&, const T&)) {
    if (entries.empty()) return;
    Block block(top.key(name), 4);
    for (const T& entry : entries)
        write(block.key(table_key(entry)), entry);
    block.close();
}

// Returns an array of these numbers; a number equal to that of `old` at its index retains its
// spelling.
std::string number_array(std::initializer_list<double> numbers, const Value& old) {
    size_t i = 0;
    const auto spelled = [&](double number) {
        const Value kept = old.is(Kind::array) && i < old.size() ? old.at(i) : Value();
        ++i;
        const bool same = kept.is(Kind::number) && kept.as_number() == number;
        return same ? std::string(kept.spelling()) : shortest(number);
    };
    return "[" + joined(numbers, ", ", spelled) + "]";
}

// Writes a frame (text key "title") or note ("text").
void write_box(std::string& out, const Box& box, const char* text_key) {
    if (write_whole(out, box.source)) return;
    Block block(out, Block::flat);
    if (!box.text.empty()) block.key(text_key) += json_quoted(box.text);
    if (!has(box.unknown, "rect"))
        block.key("rect") += number_array({box.rect.x, box.rect.y, box.rect.width, box.rect.height},
                                          box.source.find("rect"));
    block.verbatim(box.unknown);
    block.close();
}

void write_boxes(Block& layout, const char* name, const Table<Box>& boxes, const char* text_key) {
    if (boxes.empty()) return;
    Block block(layout.key(name), 6);
    for (const Box& box : boxes)
        write_box(block.key(box.id), box, text_key);
    block.close();
}

void write_layout(Block& top, const Document& document) {
    if (document.positions.empty() && document.frames.empty() && document.notes.empty() &&
        document.unknown_layout.empty())
        return;
    Block layout(top.key("layout"), 4);
    for (const Position& position : document.positions)
        layout.key(position.id) += number_array({position.x, position.y}, position.source);
    write_boxes(layout, "$frames", document.frames, "title");
    write_boxes(layout, "$notes", document.notes, "text");
    layout.verbatim(document.unknown_layout);
    layout.close();
}

void write_head(Block& top, const Document& document) {
    for (const Extra& extra : document.unknown)
        if (extra.key == "$schema") top.verbatim(extra);
    if (!has(document.unknown, "wrinkle")) top.key("wrinkle") += "1";
    if (!document.name.empty()) top.key("name") += json_quoted(document.name);
    if (document.back_faces)
        top.key("back_faces") +=
            json_quoted(back_faces_names[static_cast<size_t>(*document.back_faces)]);
    write_table(top, "inputs", document.inputs, write_graph_input);
    write_table(top, "presets", document.presets, write_preset);
}

}  // namespace

std::string write_document(const Document& document) {
    if (!document.edited && document.source.has_location())
        return std::string(document.source.source());
    return canonical_text(document);
}

std::string canonical_text(const Document& document) {
    std::string out;
    Block top(out, 2);
    write_head(top, document);
    if (!has(document.unknown, "nodes")) {
        Block nodes(top.key("nodes"), 4);
        for (const NodePtr& node : document.nodes)
            write_node(nodes.key(node->id), *node);
        nodes.close();
    }
    if (!has(document.unknown, "outputs")) {
        Block outputs(top.key("outputs"), 4);
        for (const Output& output : document.outputs)
            outputs.key(output.name) += one_line(output.from.value);
        outputs.close();
    }
    write_layout(top, document);
    for (const Extra& extra : document.unknown)
        if (extra.key != "$schema") top.verbatim(extra);
    top.close();
    return out + "\n";
}

}  // namespace wrinkle
