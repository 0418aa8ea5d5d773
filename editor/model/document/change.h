// Classifies the difference between two snapshots by comparing pointers; the kind determines the
// work to repeat.
//
// Nodes are identified by their index in the table: a renamed node is the same node, and a node
// that was moved in the table is a change of structure.
#pragma once

#include <string>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

struct Change {
    enum class Kind : uint8_t {
        none,
        cosmetic,   // only the layout: generated sources do not change
        names,      // node ids and references to them: sources differ only in names
        values,     // literals at ports, defaults of the graph's inputs and presets, possibly also
                    // names: updating uniforms may suffice
        structure,  // everything else
    };
    struct Place {
        std::string node, port;  // the node's id in `after`
        size_t index = 0;        // the node's index in both tables
    };
    Kind kind = Kind::none;
    bool renamed = false;       // set for names and values
    std::vector<Place> values;  // for Kind::values: ports with different literals
    // For Kind::values: defaults of the graph's inputs or presets may differ; changed_inputs()
    // (inputs.h) returns those with another value.
    bool inputs = false;
};

Change change(const Document& before, const Document& after);

// Returns true if two snapshots share everything that an edit can change.
bool same_document(const Document& a, const Document& b);

}  // namespace wrinkle::editor
