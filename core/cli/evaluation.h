// A graph's outputs at points, in numbers.
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

// Every output at every point, block by block: `take` gets the columns of the points first ... on,
// of no points at all once. False with a problem reported. The run was compiled with given
// differentials, and its images are in `textures`.
using TakeColumns =
    std::function<void(size_t first, size_t count, const std::vector<OutputColumn>& columns)>;
bool evaluate_blocks(const MaterialRun& run, const TextureStore& textures,
                     const PointSource& source, Precision precision, const TakeColumns& take,
                     Diagnostics& diagnostics);

// The same in one piece; nothing with a problem reported.
std::optional<std::vector<OutputColumn>> evaluate_at(const MaterialRun& run,
                                                     const TextureStore& textures,
                                                     const std::vector<Point>& points,
                                                     Precision precision, Diagnostics& diagnostics);

// {"normal": [0, 0, 1], "height": 0.5}: one point. Numbers read back as the same value of their
// precision; one that is not finite is null.
void append_values_json(std::string& text, const std::vector<OutputColumn>& columns, size_t point,
                        Precision precision);
std::string values_json(const std::vector<OutputColumn>& columns, size_t point,
                        Precision precision);

}  // namespace wrinkle::cli
