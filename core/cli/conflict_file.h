// NAME.json.conflicts, the open conflicts of the graph NAME.json (difference/conflicts.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "difference/conflicts.h"

namespace wrinkle::cli {

inline std::string conflict_file_of(const std::string& graph) {
    return graph + std::string(difference::conflicts_suffix);
}

// Returns an empty list without such a file, std::nullopt with an error if it is damaged.
std::optional<std::vector<difference::Conflict>> open_conflicts(const std::string& graph,
                                                                Diagnostics& diagnostics);

// Reports an error for each open conflict, at its node and port.
void report_conflicts(const std::string& graph, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
