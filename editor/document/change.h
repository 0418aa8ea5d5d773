// What differs between two snapshots, found by comparing pointers: what has to be done again.
//
// Nodes are told apart by their place in the table, so a renamed node is the same node; a node that
// was moved in the table is a change of structure.
#pragma once

#include <string>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

struct Change {
    enum class Kind : uint8_t {
        none,
        cosmetic,   // layout alone: no text changes
        names,      // ids of nodes, and what follows them: the text reads differently, no more
        values,     // literals at ports, and names perhaps: a uniform may be all there is to do
        structure,  // everything else
    };
    struct Place {
        std::string node, port;  // the node's id afterwards
        size_t index = 0;        // the node's place in both tables
    };
    Kind kind = Kind::none;
    bool renamed = false;       // of names and values
    std::vector<Place> values;  // of Kind::values, each place whose literal differs
};

Change change(const Document& before, const Document& after);

}  // namespace wrinkle::editor
