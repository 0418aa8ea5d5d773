// Output of `wrinkle eval`: a graph's outputs at its points as JSON, CSV or NPY.
//
//   json  "points": [{"normal": [0, 0, 1], "height": 0.5}, ...]; null if not finite
//   csv   normal.x,normal.y,normal.z,height and one line per point; nan, inf, -inf
//   npy   records with the same field names (cli/npy.h): <f4, or <f8 with double precision
//
// Numbers round-trip in their precision.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cpu/columns.h"

namespace wrinkle::cli {

// `form` is "json", "csv" or "npy".
std::string eval_text(std::string_view form, const std::vector<OutputColumn>& columns,
                      size_t points, Precision precision);

// Returns one point as JSON: {"normal": [0, 0, 1], "height": 0.5}.
std::string values_json(const std::vector<OutputColumn>& columns, size_t point,
                        Precision precision);

}  // namespace wrinkle::cli
