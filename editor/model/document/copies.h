// Copies nodes under new ids.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

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

}  // namespace wrinkle::editor
