#include "editor/view/edit/layer.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "editor/model/document/field.h"
#include "editor/model/document/wiring.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

std::string id_after(const Document& document, std::string_view wish, std::string_view type) {
    std::string id(wish.substr(0, 64));
    for (char& c : id)
        if (c == '.' || c == ' ' || std::iscntrl(static_cast<unsigned char>(c))) c = '_';
    return free_id(document, id_problem(id).empty() ? id : type);
}

// Returns the node type that adds two bumps on a wire from `from` to `to`; nullptr if there is
// none.
const NodeType* adder(const State& state, PortType from, PortType to, PortType bump) {
    const auto fits = [&](PortType kind) {
        return converts(from, kind) && converts(bump, kind) && converts(kind, to);
    };
    if (from == PortType::height_ && to == PortType::height_ && fits(PortType::height_))
        return state.registry->find("height_add");
    return fits(PortType::gradient_) ? state.registry->find("gradient_add") : nullptr;
}

// Returns the other input of an addition at the wire's end if it is free and takes the bump;
// otherwise "".
std::string free_input(const State& state, const Document& document, const Wire& wire,
                       PortType bump) {
    const Node* reader = document.find(wire.node);
    if (!reader || (reader->type != "gradient_add" && reader->type != "height_add")) return {};
    const std::string other = wire.port == "a" ? "b" : "a";
    const Port* port = input_port(state.registry->find(reader->type), other);
    return port && converts(bump, port->type) && !reader->find(other) ? other : "";
}

}  // namespace

NewNode with_node(const State& state, const Document& document, const NodeType& type,
                  std::string_view wish, ImVec2 at) {
    Node node = node_of_type(document, type);
    node.id = id_after(document, wish, type.id);
    const std::string id = node.id;
    const ImVec2 place = free_place(state, document, at, node, &type);
    return {add_node(document, std::move(node), place.x, place.y), id};
}

NewNode with_image_node(const State& state, const NodeType& type, const std::string& file,
                        ImVec2 at) {
    const std::string stem = std::filesystem::path(file).stem().string();
    NewNode made = with_node(state, state.document(), type, stem, at);
    if (const Port* port = image_port(type))
        made.document = set_value(made.document, made.id, port->name, json::Value::string(file));
    return made;
}

const Port* image_port(const NodeType& type, std::string_view name) {
    for (const Port& port : type.ports)
        if (port.is_value() && port.type == PortType::image_ && (name.empty() || port.name == name))
            return &port;
    return nullptr;
}

const Port* bump_of(const NodeType& type) {
    const Port* height = first_output(&type, {PortType::height_});
    return height ? height : first_output(&type, {PortType::gradient_});
}

Document with_bump_shown(const State& state, const Document& document, const Link& bump,
                         ImVec2 at) {
    const NodeType* type = state.registry->find("resolve");
    if (!type) return document;
    const NewNode made = with_node(state, document, *type, type->id, at);
    const Document wired = connect(made.document, bump, made.id, "gradient");
    return set_output(wired, "normal", {made.id, "normal"});
}

std::optional<Document> with_bump_on_wire(const State& state, const Document& document,
                                          const Wire& dropped_on, const Link& bump, ImVec2 at,
                                          std::string& why) {
    const Wire wire = before_resolve(state, document, dropped_on);
    const Node* source = document.find(bump.node);
    const Port* output =
        output_port(source ? state.registry->find(source->type) : nullptr, bump.port);
    const std::string port = output ? free_input(state, document, wire, output->type) : "";
    if (!port.empty()) return connect(document, bump, wire.node, port);
    const NodeType* type =
        output ? adder(state, wire.from_type, wire.to_type, output->type) : nullptr;
    if (!type) {
        why = wire.from.text() + " carries no bump to lay another over";
        return std::nullopt;
    }
    const NewNode made = with_node(state, document, *type, type->id, at);
    Document result = connect(made.document, wire.from, made.id, "a");
    result = connect(result, bump, made.id, "b");
    return with_wire(result, {made.id, first_output(type)->name}, wire.node, wire.port);
}

bool takes_bump(const State& state, const Wire& dropped_on, PortType bump) {
    const Wire wire = before_resolve(state, state.document(), dropped_on);
    return adder(state, wire.from_type, wire.to_type, bump) != nullptr;
}

Wire before_resolve(const State& state, const Document& document, const Wire& wire) {
    const Node* source = document.find(wire.from.node);
    if (!source || source->type != "resolve") return wire;
    const Wire* into = state.layout.wire_to({source->id, "gradient"});
    return into ? *into : wire;
}

void leave_empty_graph(CanvasState& canvas) {
    static_cast<Borders&>(canvas.view) = {};
    canvas.view.fitted = false;
}

}  // namespace wrinkle::editor
