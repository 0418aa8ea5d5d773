#include "editor/document/copies.h"

#include <algorithm>
#include <cmath>

#include "editor/canvas/boxes.h"
#include "editor/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// "noise" of "noise12", so that a copy of a copy is "noise13".
std::string stem_of(std::string_view id) {
    const size_t last = id.find_last_not_of("0123456789");
    return std::string(last == id.npos ? id : id.substr(0, last + 1));
}

bool is_near(double x, double y, double other_x, double other_y) {
    return std::fabs(x - other_x) < 24 && std::fabs(y - other_y) < 24;
}

}  // namespace

BoxCopies with_boxes(const Document& target, const Document& source, const std::set<BoxId>& ids,
                     ImVec2 by) {
    BoxCopies copies{target, {}};
    for (const BoxId& id : ids) {
        const Box* found = find_box(source, id);
        if (!found) continue;
        Box box = *found;
        box.id = free_box_id(copies.document, id.note);
        box.rect.x += by.x;
        box.rect.y += by.y;
        copies.ids.insert({id.note, box.id});
        copies.document = with_box(copies.document, id.note, std::move(box));
    }
    return copies;
}

ImVec2 free_offset(const State& state, const std::vector<ImVec2>& places, const Document& source,
                   const std::set<BoxId>& boxes, ImVec2 by) {
    by = {std::round(by.x / 8) * 8, std::round(by.y / 8) * 8};
    const auto is_on_card = [&](const ImVec2& place) {
        for (const Card& card : state.layout.cards)
            if (is_near(place.x + by.x, place.y + by.y, card.at.x, card.at.y)) return true;
        return false;
    };
    const auto is_on_box = [&](const BoxId& id) {
        const Rectangle& rect = find_box(source, id)->rect;
        for (const Box& box : id.note ? state.document().notes : state.document().frames)
            if (is_near(rect.x + by.x, rect.y + by.y, box.rect.x, box.rect.y)) return true;
        return false;
    };
    for (int tries = 0; tries < 256 && (std::any_of(places.begin(), places.end(), is_on_card) ||
                                        std::any_of(boxes.begin(), boxes.end(), is_on_box));
         ++tries)
        by = by + ImVec2(32, 32);
    return by;
}

Copies copies_of(const Document& source, const std::set<std::string>& ids, const Document& target,
                 const std::function<bool(const Link&)>& keep) {
    Copies copies;
    std::set<std::string> taken;
    std::vector<Node> nodes;
    for (const NodePtr& node : source.nodes) {
        if (!ids.contains(node->id)) continue;
        Node copy = *node;
        copy.id = free_id(target, stem_of(node->id), taken);
        taken.insert(copy.id);
        copies.new_id[node->id] = copy.id;
        nodes.push_back(std::move(copy));
    }
    Document work = add_nodes({}, std::move(nodes), {});
    for (const auto& [old, id] : copies.new_id)
        for (const Input& input : source.find(old)->inputs) {
            if (input.kind != Input::Kind::link) continue;
            const auto inside = copies.new_id.find(input.link.node);
            if (inside != copies.new_id.end())
                work = connect(work, {inside->second, input.link.port}, id, input.port);
            else if (!keep(input.link))
                work = disconnect(work, id, input.port);
        }
    for (const NodePtr& node : work.nodes)
        copies.nodes.push_back(*node);
    return copies;
}

}  // namespace wrinkle::editor
