// Former names of a graph's inputs: "wear": { "type": "float", "renamed": ["age"] }.
//
// Presets, --set and nodes that use the graph as a sub-graph may call an input by a former name.
// Their values and wires get the current name when they are read. That is not an edit: an untouched
// file is written back byte for byte, and an edited one has the current names.
#pragma once

#include <string_view>
#include <unordered_map>

#include "graph/document.h"

namespace wrinkle {

class FormerNames {
public:
    explicit FormerNames(Table<GraphInput> inputs);

    bool empty() const { return current_.empty(); }
    // Returns the name of the input that had this name; "" if there is none, or if an input has
    // this name now. Of several inputs it is the first; check() reports them.
    std::string_view current(std::string_view name) const;

private:
    Table<GraphInput> inputs_;  // owner of the names
    std::unordered_map<std::string_view, std::string_view> current_;
};

// Return the preset, or the node of a sub-graph, with current names. A former name is unchanged
// if there is an entry for the same input before it or with the current name. A node without a
// change is the same node.
Preset with_current_names(Preset preset, const FormerNames& names);
NodePtr with_current_names(const NodePtr& node, const FormerNames& names);

}  // namespace wrinkle
