// Compares results with the expected values of a test.
#pragma once

#include <string>
#include <vector>

#include "cli/evaluation.h"
#include "cli/test_case.h"

namespace wrinkle::cli {

// Returns one sentence per output of the point that differs from `expected` (an object) or that
// cannot be compared; empty if all are equal within the tolerances. `document` provides the node of
// each output, for messages.
std::vector<std::string> differences(const TestCase& test, const Document& document,
                                     const json::Value& expected,
                                     const std::vector<OutputColumn>& columns, size_t point);

// Returns the RMS difference over all channels in 8-bit steps; negative if the sizes differ.
double picture_difference(const Image& expected, const Image& got);

}  // namespace wrinkle::cli
