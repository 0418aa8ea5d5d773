#include "graph/edit.h"

#include <algorithm>

#include "graph/edit_parts.h"
#include "graph/values.h"

namespace wrinkle {

using json::Value;

namespace editing {
namespace {

void forget(std::vector<Extra>& extras, std::string_view key) {
    std::erase_if(extras, [&](const Extra& extra) { return extra.key == key; });
}

}  // namespace

void mark_edited(Document& document) {
    document.edited = true;
    if (!document.nodes.empty()) forget(document.unknown, "nodes");
    if (!document.inputs.empty()) forget(document.unknown, "inputs");
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

Document with_node(const Document& document, Node node) {
    Document changed = document;
    mark_edited(node);
    changed.nodes = document.nodes.with(std::make_shared<const Node>(std::move(node)));
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
    return change(copy) ? with_node(document, std::move(copy)) : document;
}

Input* input_of(Node& node, std::string_view port) {
    for (Input& input : node.inputs)
        if (input.port == port) return &input;
    return nullptr;
}

bool put(Node& node, Input input) {
    Input* old = input_of(node, input.port);
    if (!old) {
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

template <class T>
Document with_table(const Document& document, Table<T> Document::*table, Table<T> value) {
    if ((document.*table).same(value)) return document;
    Document changed = document;
    changed.*table = std::move(value);
    mark_edited(changed);
    return changed;
}

// Applies `change` to every node that has a link for which change.applies() is true.
template <class Change>
void change_links(Document& document, Change change) {
    std::vector<NodePtr> nodes(document.nodes.begin(), document.nodes.end());
    for (NodePtr& node : nodes) {
        const auto is_changed = [&](const Input& input) { return change.applies(input.link); };
        if (std::none_of(node->inputs.begin(), node->inputs.end(), is_changed)) continue;
        Node copy = *node;
        change.to_inputs(copy.inputs);
        node = std::make_shared<const Node>(std::move(copy));
    }
    document.nodes = Table<NodePtr>(std::move(nodes));
}

struct RenameLinks {
    std::string_view id, new_id;
    bool applies(const Link& link) const { return link.node == id; }
    void to_input(Input& input) const {
        if (applies(input.link)) editing::set_link(input, {std::string(new_id), input.link.port});
    }
    void to_inputs(std::vector<Input>& inputs) const {
        for (Input& input : inputs)
            to_input(input);
    }
};

bool equal(const std::vector<Extra>& a, const std::vector<Extra>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Extra& x, const Extra& y) {
        return x.key == y.key && x.value == y.value;
    });
}

Document set_box(const Document& document, Table<Box> Document::*table, Box box) {
    if (!id_problem(box.id, false).empty()) return document;
    if (const Box* old = (document.*table).find(box.id)) {
        if (old->text == box.text && old->rect == box.rect && equal(old->unknown, box.unknown))
            return document;
        box.source = old->source.is(json::Kind::object) ? old->source : Value();
    }
    return with_table(document, table, (document.*table).with(std::move(box)));
}

}  // namespace

Document add_node(const Document& document, Node node) {
    if (!id_problem(node.id).empty() || document.find(node.id)) return document;
    return with_node(document, std::move(node));
}

Document add_node(const Document& document, Node node, double x, double y) {
    const std::string id = node.id;
    Document changed = add_node(document, std::move(node));
    return changed.nodes.same(document.nodes) ? document : move_node(changed, id, x, y);
}

Document remove_node(const Document& document, std::string_view id) {
    return remove_nodes(document, {std::string(id)});
}

Document rename_node(const Document& document, std::string_view id, std::string_view new_id) {
    const Node* node = document.find(id);
    if (!node || !id_problem(new_id).empty() || document.find(new_id)) return document;
    const RenameLinks rename{id, new_id};
    Document changed = document;
    std::vector<NodePtr> nodes(document.nodes.begin(), document.nodes.end());
    Node renamed = *node;
    renamed.id = new_id;
    nodes[document.nodes.index_of(id)] = std::make_shared<const Node>(std::move(renamed));
    changed.nodes = Table<NodePtr>(std::move(nodes));
    change_links(changed, rename);
    std::vector<Output> outputs(document.outputs.begin(), document.outputs.end());
    for (Output& output : outputs)
        rename.to_input(output.from);
    changed.outputs = Table<Output>(std::move(outputs));
    std::vector<Position> positions(document.positions.begin(), document.positions.end());
    for (Position& position : positions)
        if (position.id == id) position.id = new_id;
    changed.positions = Table<Position>(std::move(positions));
    mark_edited(changed);
    return changed;
}

std::string free_id(const Document& document, std::string_view base,
                    const std::set<std::string>& taken) {
    std::string id(base);
    if (!id_problem(id).empty()) id = "node";
    const std::string stem = id;
    for (size_t n = 2; document.find(id) || taken.contains(id); ++n)
        id = stem + std::to_string(n);
    return id;
}

Document connect(const Document& document, const Link& from, std::string_view id,
                 std::string_view port) {
    if (!is_possible(from) || port.empty()) return document;
    return change_node(document, id, [&](Node& node) {
        const Input* old = node.find(port);
        if (old && old->link == from) return false;
        const Value value = link_value(from, old ? old->value : Value());
        return put(node, {std::string(port), Input::Kind::link, from, value});
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

Document set_muted(const Document& document, std::string_view id, bool muted) {
    return change_node(document, id,
                       [&](Node& node) { return std::exchange(node.muted, muted) != muted; });
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
    const Output* old = document.outputs.find(name);
    if (old && old->from.link == from) return document;
    const Value value = link_value(from, old ? old->from.value : Value());
    const std::string key(name);
    return with_table(document, &Document::outputs,
                      document.outputs.with({key, {key, Input::Kind::link, from, value}}));
}

Document remove_output(const Document& document, std::string_view name) {
    return with_table(document, &Document::outputs, document.outputs.without(name));
}

Document set_graph_input(const Document& document, GraphInput input) {
    if (!id_problem(input.name, false).empty()) return document;
    const GraphInput* old = document.inputs.find(input.name);
    if (old && old->type == input.type && old->default_value == input.default_value &&
        old->doc == input.doc && equal(old->unknown, input.unknown))
        return document;
    if (!input.source.is(json::Kind::object)) input.source = {};
    return with_table(document, &Document::inputs, document.inputs.with(std::move(input)));
}

Document remove_graph_input(const Document& document, std::string_view name) {
    return with_table(document, &Document::inputs, document.inputs.without(name));
}

Document set_name(const Document& document, std::string_view name) {
    if (document.name == name) return document;
    Document changed = document;
    changed.name = name;
    mark_edited(changed);
    return changed;
}

Document set_back_faces(const Document& document, std::optional<BackFaces> choice) {
    if (document.back_faces == choice) return document;
    Document changed = document;
    changed.back_faces = choice;
    mark_edited(changed);
    return changed;
}

Document move_node(const Document& document, std::string_view id, double x, double y) {
    return move_nodes(document, {{std::string(id), x, y}});
}

Document set_frame(const Document& document, Box frame) {
    return set_box(document, &Document::frames, std::move(frame));
}

Document remove_frame(const Document& document, std::string_view id) {
    return with_table(document, &Document::frames, document.frames.without(id));
}

Document set_note(const Document& document, Box note) {
    return set_box(document, &Document::notes, std::move(note));
}

Document remove_note(const Document& document, std::string_view id) {
    return with_table(document, &Document::notes, document.notes.without(id));
}

}  // namespace wrinkle
