#include "graph/edit.h"

#include <algorithm>

#include "graph/edit_parts.h"

namespace wrinkle {

using json::Value;

namespace editing {
namespace {

void forget(std::vector<Extra>& extras, std::string_view key) {
    std::erase_if(extras, [&](const Extra& extra) { return extra.key == key; });
}

// Returns {"from": "NODE.PORT"} with the unknown keys of `old` if that is a link object.
Value link_value(const Link& link, const Value& old) {
    std::vector<std::pair<std::string, Value>> members{{"from", Value::string(link.text())}};
    if (old.has("from"))
        for (const auto& [key, value] : old.children())
            if (key != "from") members.emplace_back(key, value);
    return Value::object(members);
}

}  // namespace

void mark_edited(Document& document) {
    document.edited = true;
    if (!document.nodes.empty()) forget(document.unknown, "nodes");
    if (!document.inputs.empty()) forget(document.unknown, "inputs");
    if (!document.presets.empty()) forget(document.unknown, "presets");
    if (!document.outputs.empty()) forget(document.unknown, "outputs");
    if (!document.positions.empty() || !document.frames.empty() || !document.notes.empty())
        forget(document.unknown, "layout");
    if (!document.name.empty()) forget(document.unknown, "name");
    if (document.back_faces) forget(document.unknown, "back_faces");
}

void mark_edited(Node& node) {
    if (!node.inputs.empty()) forget(node.unknown, "in");
    if (!node.type.empty()) forget(node.unknown, "type");
    if (node.version > 1) forget(node.unknown, "version");
    if (node.muted) forget(node.unknown, "muted");
}

Node copy_of(const Node& node) {
    Node copy = node;
    if (!copy.source.is(json::Kind::object)) copy.source = {};  // the edit makes it a node
    return copy;
}

void set_link(Input& input, Link link) {
    input.link = std::move(link);
    input.value = link_value(input.link, input.value);
}

}  // namespace editing

namespace {

using editing::copy_of;
using editing::mark_edited;
using editing::set_link;

template <class T>
Document with_table(const Document& document, Table<T> Document::*table, Table<T> value) {
    if ((document.*table).same(value)) return document;
    Document changed = document;
    changed.*table = std::move(value);
    mark_edited(changed);
    return changed;
}

// Returns the document with `change` applied to a copy of the node; `change` returns false for no
// change.
template <class Change>
Document change_node(const Document& document, std::string_view id, Change change) {
    const Node* node = document.find(id);
    if (!node) return document;
    Node copy = copy_of(*node);
    if (!change(copy)) return document;
    mark_edited(copy);
    return with_table(document, &Document::nodes,
                      document.nodes.with(std::make_shared<const Node>(std::move(copy))));
}

bool put(Node& node, Input input) {
    const auto old = std::ranges::find(node.inputs, input.port, &Input::port);
    if (old == node.inputs.end()) {
        node.inputs.push_back(std::move(input));
        return true;
    }
    if (old->kind == input.kind && old->link == input.link && old->value == input.value)
        return false;
    *old = std::move(input);
    return true;
}

bool erase(Node& node, std::string_view port) {
    return std::erase_if(node.inputs, [&](const Input& input) { return input.port == port; }) > 0;
}

bool is_possible(const Link& link) {
    const bool node = link.is_surface() || link.is_input() || id_problem(link.node).empty();
    return node && !link.port.empty() && link.port.find('.') == link.port.npos;
}

// Returns `value`; numbers equal to `old`, or to its element at the same index, retain its
// spelling.
Value with_old_spelling(const Value& value, const Value& old) {
    if (value.is(json::Kind::number) && value == old) return old;
    if (!value.is(json::Kind::array) || !old.is(json::Kind::array)) return value;
    std::vector<Value> items;
    for (const json::Member& item : value.children()) {
        const size_t i = items.size();
        const bool keep =
            item.value.is(json::Kind::number) && i < old.size() && old.at(i) == item.value;
        items.push_back(keep ? old.at(i) : item.value);
    }
    return Value::array(items);
}

bool equal(const std::vector<Extra>& a, const std::vector<Extra>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Extra& x, const Extra& y) {
        return x.key == y.key && x.value == y.value;
    });
}

}  // namespace

Document connect(const Document& document, const Link& from, std::string_view id,
                 std::string_view port) {
    if (!is_possible(from) || port.empty()) return document;
    return change_node(document, id, [&](Node& node) {
        const Input* old = node.find(port);
        if (old && old->link == from) return false;
        Input input{std::string(port), Input::Kind::link, {}, old ? old->value : Value()};
        set_link(input, from);
        return put(node, std::move(input));
    });
}

Document disconnect(const Document& document, std::string_view id, std::string_view port) {
    return change_node(document, id, [&](Node& node) {
        const Input* old = node.find(port);
        return old && old->kind != Input::Kind::literal && erase(node, port);
    });
}

Document set_value(const Document& document, std::string_view id, std::string_view port,
                   Value value) {
    if (port.empty() || value.has("from")) return document;
    return change_node(document, id, [&](Node& node) {
        const Input* old = node.find(port);
        const Value kept = old ? with_old_spelling(value, old->value) : value;
        return put(node, {std::string(port), Input::Kind::literal, {}, kept});
    });
}

Document reset_value(const Document& document, std::string_view id, std::string_view port) {
    return change_node(document, id, [&](Node& node) { return erase(node, port); });
}

Document set_type(const Document& document, std::string_view id, std::string_view type,
                  int version) {
    return change_node(document, id, [&](Node& node) {
        if (node.type == type && node.version == version) return false;
        node.type = type;
        node.version = version;
        return true;
    });
}

Document set_output(const Document& document, std::string_view name, const Link& from) {
    if (!is_possible(from) || !id_problem(name, false).empty()) return document;
    const Output* old = document.find_output(name);
    if (old && old->from.link == from) return document;
    const std::string key(old ? old->name : name);
    Output output{key, {key, Input::Kind::link, {}, old ? old->from.value : Value()}};
    set_link(output.from, from);
    return with_table(document, &Document::outputs, document.outputs.with(std::move(output)));
}

Document remove_output(const Document& document, std::string_view name) {
    return with_table(document, &Document::outputs, document.outputs.without(name));
}

Document set_graph_input(const Document& document, GraphInput input) {
    if (!id_problem(input.name, false).empty()) return document;
    const GraphInput* old = document.inputs.find(input.name);
    if (old && equal(present_keys(*old), present_keys(input)) && equal(old->unknown, input.unknown))
        return document;
    if (!input.source.is(json::Kind::object)) input.source = {};
    return with_table(document, &Document::inputs, document.inputs.with(std::move(input)));
}

Document set_preset(const Document& document, Preset preset) {
    if (!id_problem(preset.name, false).empty()) return document;
    const Preset* old = document.presets.find(preset.name);
    if (old && equal(old->values, preset.values)) return document;
    if (!preset.source.is(json::Kind::object)) preset.source = {};
    return with_table(document, &Document::presets, document.presets.with(std::move(preset)));
}

Document remove_preset(const Document& document, std::string_view name) {
    return with_table(document, &Document::presets, document.presets.without(name));
}

Document set_back_faces(const Document& document, std::optional<BackFaces> choice) {
    if (document.back_faces == choice) return document;
    Document changed = document;
    changed.back_faces = choice;
    mark_edited(changed);
    return changed;
}

Document set_box(const Document& document, Table<Box> Document::*boxes, Box box) {
    if (!id_problem(box.id, false).empty()) return document;
    if (const Box* old = (document.*boxes).find(box.id)) {
        if (old->text == box.text && old->rect == box.rect && equal(old->unknown, box.unknown))
            return document;
        box.source = old->source.is(json::Kind::object) ? old->source : Value();
    }
    return with_table(document, boxes, (document.*boxes).with(std::move(box)));
}

Document remove_box(const Document& document, Table<Box> Document::*boxes, std::string_view id) {
    return with_table(document, boxes, (document.*boxes).without(id));
}

}  // namespace wrinkle
