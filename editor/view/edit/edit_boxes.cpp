// Adds frames and notes.
#include <algorithm>
#include <cmath>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

Rectangle rectangle(ImVec2 low, ImVec2 high) {
    const auto down = [](float at) { return std::floor(static_cast<double>(at) / 8) * 8; };
    const auto up = [](float at) { return std::ceil(static_cast<double>(at) / 8) * 8; };
    return {down(low.x), down(low.y), up(high.x) - down(low.x), up(high.y) - down(low.y)};
}

void commit_new(State& state, bool note, Box box, const char* name) {
    const BoxId id{note, box.id};
    const std::string merge = "box " + std::to_string(state.history.serial());
    state.commit(name, with_box(state.document(), note, std::move(box)), merge);
    state.view.boxes = {id};
    edit_box_text(state, id);
    state.box_text.merge = merge;
}

}  // namespace

void frame_selected(State& state) {
    const ImVec2 pointer = to_canvas(state.view, pointed_at(state.view));
    ImVec2 low = pointer, high = pointer + ImVec2(320, 200);
    bool any = false;
    for (const Card& card : state.layout.cards) {
        if (!state.view.selected.contains(card.id)) continue;
        const ImVec2 end = card.at + card.size;
        low = any ? ImVec2(std::min(low.x, card.at.x), std::min(low.y, card.at.y)) : card.at;
        high = any ? ImVec2(std::max(high.x, end.x), std::max(high.y, end.y)) : end;
        any = true;
    }
    if (any) low = low - ImVec2(24, 24 + title_height), high = high + ImVec2(24, 24);
    Box box;
    box.id = free_box_id(state.document(), false);
    box.text = "Frame";
    box.rect = rectangle(low, high);
    commit_new(state, false, std::move(box), "Frame");
}

void add_note(State& state) {
    const ImVec2 at = to_canvas(state.view, pointed_at(state.view));
    Box box;
    box.id = free_box_id(state.document(), true);
    box.rect = rectangle(at, at + ImVec2(240, 96));
    commit_new(state, true, std::move(box), "Note");
}

void edit_box_text(State& state, const BoxId& id) {
    const Box* box = find_box(state.document(), id);
    if (!box) return;
    state.box_text = {};
    state.box_text.open = state.box_text.opening = true;
    state.box_text.box = id;
    state.box_text.text = box->text;
}

void accept_box_text(State& state) {
    const BoxText entry = std::move(state.box_text);
    state.box_text = {};
    const Box* found = find_box(state.document(), entry.box);
    if (!found) return;
    Box box = *found;
    box.text = entry.text;
    state.commit(entry.box.note ? "Write note" : "Name frame",
                 with_box(state.document(), entry.box.note, std::move(box)), entry.merge);
}

}  // namespace wrinkle::editor
