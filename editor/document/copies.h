// Copies of nodes, frames and notes under ids of their own.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "editor/canvas/box_id.h"
#include "editor/state.h"
#include "graph/document.h"

namespace wrinkle::editor {

struct Copies {
    std::vector<Node> nodes;                    // in the source's order
    std::map<std::string, std::string> new_id;  // by the old one
};

// The nodes `ids` of `source` as they can stand in `target`. Wires among them run among the
// copies; of the others those stay that `keep` says.
Copies copies_of(const Document& source, const std::set<std::string>& ids, const Document& target,
                 const std::function<bool(const Link&)>& keep);

// The frames and notes `ids` of `source` in `target` as well, moved by `by`, and what they are
// called there.
struct BoxCopies {
    Document document;
    std::set<BoxId> ids;
};
BoxCopies with_boxes(const Document& target, const Document& source, const std::set<BoxId>& ids,
                     ImVec2 by);

// Near `by`, on the grid: so far that cards at `places` and the boxes of `source` cover no card;
// boxes cover no box either.
ImVec2 free_offset(const State& state, const std::vector<Extent>& places, const Document& source,
                   const std::set<BoxId>& boxes, ImVec2 by);

}  // namespace wrinkle::editor
