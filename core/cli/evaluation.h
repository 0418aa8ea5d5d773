// Evaluates a graph's outputs at points.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/material_run.h"
#include "cli/point_source.h"
#include "cpu/columns.h"
#include "cpu/texture_store.h"

namespace wrinkle::cli {

// Evaluates every output at every point in blocks. Calls `take` with the columns of `count` points
// from `first` on; once with count 0 if there are no points. Returns false and reports a problem on
// failure. Precondition: the run was compiled with given differentials, and `textures` holds its
// images.
using TakeColumns =
    std::function<void(size_t first, size_t count, const std::vector<OutputColumn>& columns)>;
bool evaluate_blocks(const MaterialRun& run, const TextureStore& textures,
                     const PointSource& source, Precision precision, const TakeColumns& take,
                     Diagnostics& diagnostics);

// Evaluates all points at once; returns std::nullopt and reports a problem on failure.
std::optional<std::vector<OutputColumn>> evaluate_at(const MaterialRun& run,
                                                     const TextureStore& textures,
                                                     const PointList& points, Precision precision,
                                                     Diagnostics& diagnostics);

}  // namespace wrinkle::cli
