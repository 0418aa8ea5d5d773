// Random pairs of edits of a graph with a result that is known without a merge: each edit is
// applied to a model of the graph, and edits of the two sides concern different keys or are listed
// as a conflict. Shares no code with core/difference or core/graph.
#pragma once

#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace wrinkle::test {

// Values as JSON by key; a port is "in.NAME".
using ModelKeys = std::map<std::string, std::string>;
// Entries by id. Sections: "nodes", "inputs", "presets"; "outputs" and "positions" have the key "".
using ModelSection = std::map<std::string, ModelKeys>;
using Model = std::map<std::string, ModelSection>;

// Section, id, key; the key of an entry is "".
using ModelConflict = std::tuple<std::string, std::string, std::string>;

struct EditPair {
    Model base, ours, theirs, expected;
    std::set<ModelConflict> conflicts;
    std::vector<std::string> log;  // one line per edit, for messages
};
EditPair random_edits(unsigned seed);

// As a graph file; not canonical.
std::string model_text(const Model& model);
Model model_of(const std::string& text);

}  // namespace wrinkle::test
