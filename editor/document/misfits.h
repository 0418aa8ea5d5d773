// Wires that do not fit, after nodes came from somewhere else.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "editor/document/model.h"

namespace wrinkle::editor {

// Without the wires into these nodes, and from them, whose types do not convert: a reroute that
// came without what fed it carries a float.
Document without_misfits(const Document& document, const std::set<std::string>& ids,
                         const std::filesystem::path& folder, const Registry& registry);

}  // namespace wrinkle::editor
