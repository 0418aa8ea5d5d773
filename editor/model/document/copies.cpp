#include "editor/model/document/copies.h"

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/new_cards.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"

namespace wrinkle::editor {
namespace {

// Returns "noise" for "noise12", so that a copy of a copy is "noise13".
std::string stem_of(std::string_view id) {
    const size_t last = id.find_last_not_of("0123456789");
    return std::string(last == id.npos ? id : id.substr(0, last + 1));
}

Extent extent_of(const Box& box) {
    const ImVec2 low(static_cast<float>(box.rect.x), static_cast<float>(box.rect.y));
    return {low,
            low + ImVec2(static_cast<float>(box.rect.width), static_cast<float>(box.rect.height))};
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

ImVec2 free_offset(const State& state, const std::vector<Extent>& places, const Document& source,
                   const std::set<BoxId>& boxes, ImVec2 by) {
    std::vector<Extent> fixed = card_extents(state), moving = places;
    for (const BoxId& id : boxes)
        moving.push_back(extent_of(*find_box(source, id)));
    if (!boxes.empty())
        for (const BoxId& id : all_boxes(state.document()))
            fixed.push_back(extent_of(*find_box(state.document(), id)));
    return free_shift(fixed, std::move(moving), by);
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
