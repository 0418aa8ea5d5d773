// Renamed nodes, found by their content: graph files do not record renames.
#pragma once

#include <map>
#include <string>

#include "difference/entries.h"

namespace wrinkle::difference {

// New ids by old ids.
using Renames = std::map<std::string, std::string>;

// A node is renamed if exactly one removed and one added node have the same type and values, and
// every wire from the old node now comes from the new one. A node that was renamed and changed at
// once is a deleted and an added node.
Renames find_renames(const Entries& before, const Entries& after);

}  // namespace wrinkle::difference
