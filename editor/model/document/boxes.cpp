#include "editor/model/document/boxes.h"

#include "graph/edit.h"

namespace wrinkle::editor {

namespace {

Table<Box> Document::*table_of(bool note) {
    return note ? &Document::notes : &Document::frames;
}

}  // namespace

const Box* find_box(const Document& document, const BoxId& id) {
    return (document.*table_of(id.note)).find(id.id);
}

Document with_box(const Document& document, bool note, Box box) {
    return set_box(document, table_of(note), std::move(box));
}

Document without_box(const Document& document, const BoxId& id) {
    return remove_box(document, table_of(id.note), id.id);
}

std::string free_box_id(const Document& document, bool note) {
    const std::string stem = note ? "note" : "frame";
    std::string id = stem;
    for (size_t n = 2; find_box(document, {note, id}); ++n)
        id = stem + std::to_string(n);
    return id;
}

std::vector<BoxId> all_boxes(const Document& document) {
    std::vector<BoxId> boxes;
    for (const Box& frame : document.frames)
        boxes.push_back({false, frame.id});
    for (const Box& note : document.notes)
        boxes.push_back({true, note.id});
    return boxes;
}

BoxCopies with_boxes(const Document& target, const Document& source, const std::set<BoxId>& ids,
                     double x, double y) {
    BoxCopies copies{target, {}};
    for (const BoxId& id : ids) {
        const Box* found = find_box(source, id);
        if (!found) continue;
        Box box = *found;
        box.id = free_box_id(copies.document, id.note);
        box.rect.x += x;
        box.rect.y += y;
        copies.ids.insert({id.note, box.id});
        copies.document = with_box(copies.document, id.note, std::move(box));
    }
    return copies;
}

}  // namespace wrinkle::editor
