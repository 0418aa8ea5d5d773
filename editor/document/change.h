// What differs between two snapshots, found by comparing pointers: what has to be done again.
#pragma once

#include <string>
#include <vector>

#include "graph/document.h"

namespace wrinkle::editor {

struct Change {
    enum class Kind : uint8_t {
        none,
        cosmetic,   // layout alone: no text changes
        values,     // literals at ports: a uniform may be all there is to do
        structure,  // everything else
    };
    struct Place {
        std::string node, port;
    };
    Kind kind = Kind::none;
    std::vector<Place> values;  // of Kind::values, each place whose literal differs
};

Change change(const Document& before, const Document& after);

}  // namespace wrinkle::editor
