// Frames and notes of a document.
#pragma once

#include <compare>
#include <set>
#include <string>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

// Frames and notes have separate name spaces.
struct BoxId {
    bool note = false;
    std::string id;
    auto operator<=>(const BoxId&) const = default;
};

const Box* find_box(const Document& document, const BoxId& id);
Document with_box(const Document& document, bool note, Box box);
Document without_box(const Document& document, const BoxId& id);
std::string free_box_id(const Document& document, bool note);
// All boxes from bottom to top: frames, then notes.
std::vector<BoxId> all_boxes(const Document& document);

// Copies the frames and notes `ids` of `source` into `target`, moved by x and y. Returns the
// document and the new ids.
struct BoxCopies {
    Document document;
    std::set<BoxId> ids;
};
BoxCopies with_boxes(const Document& target, const Document& source, const std::set<BoxId>& ids,
                     double x, double y);

}  // namespace wrinkle::editor
