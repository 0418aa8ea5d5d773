// Renamed nodes, found by their content: format files have no other mark of a rename.
#pragma once

#include <map>
#include <string>

#include "difference/entries.h"

namespace wrinkle::difference {

// New ids by old ids.
using Renames = std::map<std::string, std::string>;

// A node is renamed if one node with its type and values is absent from `after` and one is new in
// it, no other absent or new node has this content, and every wire that read the old node reads
// the new one. A node that was renamed and changed at once is a deleted and an added node.
Renames find_renames(const Entries& before, const Entries& after);

}  // namespace wrinkle::difference
