// Runs on the nodes of a plugin the checks that the built-in nodes must pass; the report contains a
// remedy for each finding.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "certify/checks.h"

namespace wrinkle::certify {

// The names of the checks.
std::span<const std::string_view> check_names();

// Runs every check of checks.h. If "text" or "deterministic" fails, the numeric checks are skipped.
Report certify(const NodeType& type, const CertifyContext& context);

// Returns a line "ok" with the number of compared values, or "failed" followed by the findings:
//   ripples  ok: 1200 values in float, double and on the GPU, 2400 derivatives
//   crease  failed
//       derivative: port 'height': at point 3 ... (the remedy)
//           in {"wrinkle": 1, ...}
std::string to_text(const Report& report, bool gpu);

}  // namespace wrinkle::certify
