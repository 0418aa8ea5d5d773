// Copies nodes, frames and notes under new ids.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "editor/model/document/box_id.h"
#include "editor/view/state.h"
#include "graph/document.h"

namespace wrinkle::editor {

struct Copies {
    std::vector<Node> nodes;                    // in the source's order
    std::map<std::string, std::string> new_id;  // old id -> new id
};

// Copies the nodes `ids` of `source` with ids that are free in `target`. Wires among them connect
// the copies; other wires are retained if `keep` returns true.
Copies copies_of(const Document& source, const std::set<std::string>& ids, const Document& target,
                 const std::function<bool(const Link&)>& keep);

// Copies the frames and notes `ids` of `source` into `target`, moved by `by`. Returns the document
// and the new ids.
struct BoxCopies {
    Document document;
    std::set<BoxId> ids;
};
BoxCopies with_boxes(const Document& target, const Document& source, const std::set<BoxId>& ids,
                     ImVec2 by);

// Returns an offset near `by`, on the grid, at which cards at `places` and the boxes of `source`
// overlap no card, and the boxes overlap no other box.
ImVec2 free_offset(const State& state, const std::vector<Extent>& places, const Document& source,
                   const std::set<BoxId>& boxes, ImVec2 by);

}  // namespace wrinkle::editor
