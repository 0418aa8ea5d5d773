// "--set NODE.PORT=VALUE" and "--set input.NAME=VALUE": values that replace those of the top graph
// for one run.
//
// VALUE is JSON; a bare word is a string ("--set noise.kind=ridged"). A:B:N is a sweep: N numbers
// from A to B, N >= 2. A wire at the port is replaced. A node inside a sub-graph cannot be set;
// give its graph an input. An input may be called by a former name.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "graph/subgraph.h"
#include "registry/registry.h"

namespace wrinkle {

struct Override {
    std::string text;                 // as given: "tile.scale=[8, 8]"
    Link target;                      // node and port, or input and name
    std::vector<json::Value> values;  // one value, or those of a sweep

    bool is_sweep() const { return values.size() > 1; }
};

// Returns std::nullopt and reports an error if the text is not an override.
std::optional<Override> parse_override(std::string_view text, Diagnostics& diagnostics);

// Returns the project with value `run` of every override (for one without a sweep its only value).
// Errors name the override: unknown node, port or input, a value that does not fit.
Project with_overrides(const Project& project, const Registry& registry,
                       std::span<const Override> overrides, size_t run, Diagnostics& diagnostics);

}  // namespace wrinkle
