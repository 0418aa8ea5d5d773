// Holds the nodes of a plugin to what the built-in ones are held to, and says so in a report that
// its author can act on.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "certify/checks.h"

namespace wrinkle::certify {

// The names of the checks.
std::span<const std::string_view> check_names();

// Every check of checks.h. A node whose build is not deterministic, or does not compile, is not
// asked for numbers.
Report certify(const NodeType& type, const Bench& bench);

// A line: "ok" with what was compared, or "failed" and below it what and where:
//   ripples  ok: 2400 derivatives, 1200 values in float, double and on the GPU
//   crease   failed
//       derivative: port 'height': at point 3 ... (the remedy)
//       graph: {"wrinkle": 1, ...}
std::string to_text(const Report& report, bool gpu);

}  // namespace wrinkle::certify
