// Copies of nodes under ids of their own.
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
    std::map<std::string, std::string> new_id;  // by the old one
};

// The nodes `ids` of `source` as they can stand in `target`. Wires among them run among the
// copies; of the others those stay that `keep` says.
Copies copies_of(const Document& source, const std::set<std::string>& ids, const Document& target,
                 const std::function<bool(const Link&)>& keep);

}  // namespace wrinkle::editor
