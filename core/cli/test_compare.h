// Comparison of the results of a case with its baselines.
#pragma once

#include <string>
#include <vector>

#include "cli/test_case.h"
#include "cpu/columns.h"
#include "graph/document.h"
#include "image/image.h"
#include "report/results.h"

namespace wrinkle::cli {

struct CaseComparison {
    std::vector<report::Measured> measured;
    std::string difference;  // one sentence, "" if all is within the limits
};

// Compares the outputs of a point with `expected`, an object with the values of some or all of
// them. An output that the graph lacks is a difference. `document` provides the node of each
// output.
CaseComparison compare_point(const TestCase& test, const Document& document,
                             const json::Value& expected, const std::vector<OutputColumn>& columns,
                             size_t point);

struct ImageComparison : CaseComparison {
    Image map;  // color map of the difference; empty within the limits, and for other sizes
    std::string map_measure;
    double map_scale = 1;
    std::string largest;  // mean and largest value of the map, with its pixel; "" without a map
};

// Returns the metric of the map: that of the case; of `rms`, degrees for the normal view and FLIP
// for other views.
std::string map_metric(const RenderCase& render);

ImageComparison compare_images(const RenderCase& render, const Image& expected, const Image& got);

// "0.4164": four digits, for messages.
std::string short_number(double value);

// Returns one RGB image of images of one size, from left to right.
Image side_by_side(const std::vector<const Image*>& images);

}  // namespace wrinkle::cli
