// A graph's outputs at points, in numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/material_run.h"
#include "cli/points.h"
#include "cpu/columns.h"
#include "cpu/texture_store.h"

namespace wrinkle::cli {

// Every output at every point; nothing with a problem reported. The run was compiled with given
// differentials, and its images are in `textures`.
std::optional<std::vector<OutputColumn>> evaluate_at(const MaterialRun& run,
                                                     const TextureStore& textures,
                                                     const std::vector<Point>& points,
                                                     Precision precision, Diagnostics& diagnostics);

// {"normal": [0, 0, 1], "height": 0.5}: one point. Numbers read back as the same value of their
// precision; one that is not finite is null.
std::string values_json(const std::vector<OutputColumn>& columns, size_t point,
                        Precision precision);

}  // namespace wrinkle::cli
