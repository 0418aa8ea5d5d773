// Removes wires with types that do not convert, after nodes were inserted from another graph.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "editor/model/document/model.h"

namespace wrinkle::editor {

// Removes the wires into and from these nodes with types that do not convert: a reroute that lost
// its source carries a float.
Document without_invalid_links(const Document& document, const std::set<std::string>& ids,
                               const std::filesystem::path& folder, const Registry& registry);

}  // namespace wrinkle::editor
