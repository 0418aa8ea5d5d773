// Evaluates a graph's outputs at points.
#pragma once

#include <optional>
#include <vector>

#include "cli/material_run.h"
#include "cli/point_source.h"
#include "cpu/columns.h"
#include "cpu/texture_store.h"

namespace wrinkle::cli {

// Evaluates every output at every point; returns std::nullopt and reports a problem on failure.
// Precondition: the run was compiled with given differentials, and `textures` holds its images.
std::optional<std::vector<OutputColumn>> evaluate_points(const MaterialRun& run,
                                                         const TextureStore& textures,
                                                         const PointSource& source,
                                                         Precision precision,
                                                         Diagnostics& diagnostics);

}  // namespace wrinkle::cli
