#include "editor/view/edit/clipboard.h"

#include "base/file.h"
#include "editor/model/document/copies.h"
#include "editor/model/document/wiring.h"
#include "editor/model/words.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"
#include "graph/order.h"
#include "graph/read.h"
#include "graph/write.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;
namespace {

// "2 nodes and a frame", "2 notes"
std::string in_words(const Document& part) {
    std::vector<std::string> words;
    if (!part.nodes.empty()) words.push_back(counted(part.nodes.size(), "node"));
    const auto add = [&](size_t count, const std::string& what) {
        if (count > 0)
            words.push_back(count == 1 ? "a " + what : std::to_string(count) + " " + what + "s");
    };
    add(part.frames.size(), "frame");
    add(part.notes.size(), "note");
    return listed(words);
}

std::set<BoxId> boxes_of(const Document& document) {
    const std::vector<BoxId> all = all_boxes(document);
    return {all.begin(), all.end()};
}

// Returns the selected nodes, frames and notes as a separate graph, at their current positions;
// `cut` has no wires into them.
Document extract(const State& state, const Document& cut) {
    std::vector<Node> nodes;
    Document result;
    for (const NodePtr& node : cut.nodes) {
        if (!state.view.selected.contains(node->id)) continue;
        nodes.push_back(*node);
        for (const Input& input : node->inputs) {
            const bool reads = input.kind == Input::Kind::link && input.link.is_input();
            const GraphInput* read = reads ? cut.inputs.find(input.link.port) : nullptr;
            if (read) result = set_graph_input(result, *read);
        }
    }
    std::vector<NodePosition> places;
    for (const Card* card : selected_cards(state))
        places.push_back({card->id, card->at.x, card->at.y});
    for (const BoxId& id : state.view.boxes)
        if (const Box* box = find_box(cut, id)) result = with_box(result, id.note, *box);
    return add_nodes(result, std::move(nodes), places);
}

std::vector<Connection> left_out(const Document& before, const Document& after,
                                 const std::set<std::string>& ids) {
    std::vector<Connection> wires;
    for (const std::string& id : ids) {
        const Node* node = before.find(id);
        const Node* left = after.find(id);
        if (!node || !left) continue;
        for (const Input& input : node->inputs)
            if (input.kind == Input::Kind::link && !left->find(input.port))
                wires.push_back({input.link, id, input.port});
    }
    return wires;
}

std::optional<Document> refuse(std::string& why, std::string reason) {
    why = "Nothing was pasted: " + std::move(reason);
    return std::nullopt;
}

// Removes wires from nodes that are not in the text, such as a part of a file has.
Document without_dangling(const Document& document) {
    Document result = document;
    each_wire(document, [&](const Connection& wire) {
        if (!wire.node.empty() && wire.from.is_node() && !document.find(wire.from.node))
            result = without_wire(result, wire.node, wire.port);
    });
    return result;
}

// Restores the wires left out of the text if it was copied from this document and their ends exist.
Document with_outer_wires(const State& state, Document document, const std::string& text,
                          const Copies& copies) {
    const Clip& clip = state.clip;
    if (clip.text != text || clip.document != state.path) return document;
    for (const Connection& wire : clip.outer) {
        const auto reader = copies.new_id.find(wire.node);
        const auto inside = copies.new_id.find(wire.from.node);
        if (reader == copies.new_id.end()) continue;
        if (inside != copies.new_id.end()) {
            document =
                connect(document, {inside->second, wire.from.port}, reader->second, wire.port);
            continue;
        }
        const auto given = state.model.type_of(wire.from);
        const NodeType* type = state.registry->find(document.find(reader->second)->type);
        const Port* port = input_port(type, wire.port);
        const bool fits = !port || (given && converts(*given, port->type));
        if (fits && state.document().find(wire.from.node))
            document = connect(document, wire.from, reader->second, wire.port);
    }
    return document;
}

ImVec2 corner_of(const Document& document, const std::vector<Extent>& places) {
    Extent all = around(places);
    for (const BoxId& id : all_boxes(document))
        all.add(extent_of(*find_box(document, id)));
    return all.low;
}

void paste_nodes(State& state, const Document& source, const std::string& text) {
    std::set<std::string> ids;
    for (const NodePtr& node : source.nodes)
        ids.insert(node->id);
    Copies copies = copies_of(source, ids, state.document(), [&](const Link& link) {
        const GraphInput* here =
            link.is_input() ? state.document().inputs.find(link.port) : nullptr;
        const GraphInput* there = link.is_input() ? source.inputs.find(link.port) : nullptr;
        return link.is_surface() || (here && there && here->type == there->type);
    });
    const std::vector<Extent> places = places_off_canvas(state, source);
    const std::set<BoxId> boxes = boxes_of(source);
    const ImVec2 wanted = to_canvas(state.view, pointed_at(state.view)) - corner_of(source, places);
    const ImVec2 by = free_offset(state, places, source, boxes, wanted);
    std::vector<NodePosition> at;
    std::set<std::string> fresh;
    for (size_t i = 0; i < copies.nodes.size(); ++i) {
        at.push_back({copies.nodes[i].id, places[i].low.x + by.x, places[i].low.y + by.y});
        fresh.insert(copies.nodes[i].id);
    }
    const Document added = add_nodes(state.document(), copies.nodes, at);
    const Document wired = with_outer_wires(state, added, text, copies);
    const BoxCopies boxed = with_boxes(wired, source, boxes, by.x, by.y);
    state.commit("Paste " + in_words(source),
                 without_invalid_links(settled(state, boxed.document), fresh, state.folder(),
                                       *state.registry));
    show_new(state, fresh);
    state.view.boxes = boxed.ids;
}

// Path of a copy on disk: a system clipboard may lose its text when the program that set it exits.
fs::path place_to_keep(const State& state) {
    const fs::path& folder = state.keeping.folders.state;
    return folder.empty() ? fs::path() : folder / "clipboard.json";
}

void keep(const State& state, const std::string& text) {
    const fs::path place = place_to_keep(state);
    std::error_code ignored;
    std::string unheard;  // ignored: the clipboard has the text
    if (place.empty()) return;
    fs::create_directories(place.parent_path(), ignored);
    write_file(place, text, unheard);
}

std::string kept(const State& state) {
    const fs::path place = place_to_keep(state);
    std::string unheard;
    return place.empty() ? state.clip.text : read_file(place, unheard).value_or("");
}

}  // namespace

std::optional<Document> nodes_from_text(const std::string& text, std::string& why) {
    if (text.empty()) return refuse(why, "the clipboard is empty.");
    if (text.size() > max_pasted_bytes) return refuse(why, "the text is longer than 32 MB.");
    Diagnostics problems, links;
    ReadLimits limits;
    limits.nodes = max_pasted_nodes;
    const Document document = read_document(text, "clipboard", problems, limits);
    check_links(document, links);
    if (!document.lost.empty() || problems.error_count() > links.error_count()) {
        const auto& list = problems.list();
        const Location where = list.empty() ? Location() : list.front().where;
        return refuse(why, "the clipboard holds no nodes; line " + std::to_string(where.line) +
                               ": " + (list.empty() ? document.lost : list.front().message) + ".");
    }
    if (document.nodes.empty() && all_boxes(document).empty())
        return refuse(why, "the text has no nodes.");
    Document whole = without_dangling(document);
    Diagnostics loops;
    check_links(whole, loops);
    for (const Diagnostic& problem : loops.list())
        if (problem.message.find("input") == std::string::npos)
            return refuse(why, problem.message + ".");
    return whole;
}

void copy_selected(State& state) {
    const std::set<std::string>& ids = state.view.selected;
    const Document cut = without_outer_wires(state.model, state.document(), ids);
    const Document part = extract(state, cut);
    if (in_words(part).empty()) {
        state.status = "Nothing is selected that can be copied.";
        return;
    }
    state.clip.text = canonical_text(part);
    state.clip.document = state.path;
    state.clip.outer = left_out(state.document(), cut, ids);
    ImGui::SetClipboardText(state.clip.text.c_str());
    keep(state, state.clip.text);
    state.status = "Copied " + in_words(part);
}

void cut_selected(State& state) {
    copy_selected(state);
    const Document part = extract(state, state.document());
    Document document = delete_and_disconnect(state.model, state.document(), state.view.selected);
    for (const BoxId& id : state.view.boxes)
        document = without_box(document, id);
    state.commit("Cut " + in_words(part), document);
    state.view.selected.clear();
    state.view.boxes.clear();
}

void paste(State& state) {
    const char* text = ImGui::GetClipboardText();
    const std::string found = text && *text ? text : kept(state);
    std::string why;
    const auto source = nodes_from_text(found, why);
    if (source)
        paste_nodes(state, *source, found);
    else
        state.status = why;
}

}  // namespace wrinkle::editor
