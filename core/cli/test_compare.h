// How far results are from what a test expects.
#pragma once

#include <string>
#include <vector>

#include "cli/evaluation.h"
#include "cli/test_case.h"

namespace wrinkle::cli {

// One sentence for each output of the point that differs from `expected` (an object), or that
// cannot be compared; none when all agree. `document` says which node an output comes from.
std::vector<std::string> differences(const TestCase& test, const Document& document,
                                     const json::Value& expected,
                                     const std::vector<OutputColumn>& columns, size_t point);

// Root mean square of all channels in 8-bit steps; negative for pictures of different sizes.
double picture_difference(const Image& expected, const Image& got);

}  // namespace wrinkle::cli
