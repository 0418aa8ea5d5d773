// Counts and lists as text for the status.
#pragma once

#include <string>
#include <vector>

namespace wrinkle::editor {

std::string nodes_in_words(size_t count);                   // "1 node", "2 nodes"
std::string listed(const std::vector<std::string>& names);  // "a.json, b.json and c.json"

}  // namespace wrinkle::editor
