// Names with the same meaning in every graph.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "registry/port_type.h"

namespace wrinkle {

inline constexpr std::string_view reroute_type = "reroute";

// Ids of nodes, names of ports and choices: lower_snake_case that begins with a letter.
inline constexpr size_t max_name = 64;  // bytes
bool is_name(std::string_view text);

// Returns the type of a standard output of a graph: "normal" is a normal, "roughness" a float, ...;
// std::nullopt for other names.
std::optional<PortType> standard_output(std::string_view name);
std::span<const std::string_view> standard_outputs();

}  // namespace wrinkle
