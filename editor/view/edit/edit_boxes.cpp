// Adds frames and notes.
#include <algorithm>
#include <cmath>

#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/edit/edits.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

// Adds a box with its corners moved out to the grid, selects it and opens its text.
void commit_new(State& state, bool note, const Extent& extent, const char* text, const char* name) {
    const auto down = [](float at) { return std::floor(static_cast<double>(at) / 8) * 8; };
    const auto up = [](float at) { return std::ceil(static_cast<double>(at) / 8) * 8; };
    const double x = down(extent.low.x), y = down(extent.low.y);
    Box box;
    box.id = free_box_id(state.document(), note);
    box.text = text;
    box.rect = {x, y, up(extent.high.x) - x, up(extent.high.y) - y};
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
    Extent cards;
    for (const Card& card : state.layout.cards)
        if (state.view.selected.contains(card.id)) cards.add(card.extent());
    const Extent extent = cards.empty() ? Extent{pointer, pointer + ImVec2(320, 200)}
                                        : Extent{cards.low - ImVec2(24, 24 + title_height),
                                                 cards.high + ImVec2(24, 24)};
    commit_new(state, false, extent, "Frame", "Frame");
}

void add_note(State& state) {
    const ImVec2 at = to_canvas(state.view, pointed_at(state.view));
    commit_new(state, true, {at, at + ImVec2(240, 96)}, "", "Note");
}

void edit_box_text(State& state, const BoxId& id) {
    const Box* box = find_box(state.document(), id);
    if (!box) return;
    state.box_text = {true, true, id, box->text, ""};
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
