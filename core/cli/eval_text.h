// Output of `wrinkle eval`: a graph's outputs at its points as JSON, CSV or NPY.
//
//   json  "points": [{"normal": [0, 0, 1], "height": 0.5}, ...]; null if not finite
//   csv   normal.x,normal.y,normal.z,height and one line per point; nan, inf, -inf
//   npy   records with the same field names (cli/npy.h): <f4, or <f8 with double precision
//
// Numbers round-trip in their precision.
#pragma once

#include <string>
#include <vector>

#include "cpu/columns.h"

namespace wrinkle::cli {

enum class EvalForm : uint8_t { json, csv, npy };

class EvalText {
public:
    EvalText(EvalForm form, Precision precision, size_t points)
        : form_(form), precision_(precision), points_(points) {}

    // Appends the next `count` points; the counts must add up to `points`. With no points, call it
    // once with count 0.
    void add(size_t count, const std::vector<OutputColumn>& columns);
    std::string take();

private:
    void begin(const std::vector<OutputColumn>& columns);
    void add_csv(double value);
    void add_binary(double value);

    EvalForm form_;
    Precision precision_;
    size_t points_, done_ = 0;
    bool begun_ = false;
    std::string text_;
};

// Returns one point as JSON: {"normal": [0, 0, 1], "height": 0.5}.
std::string values_json(const std::vector<OutputColumn>& columns, size_t point,
                        Precision precision);

}  // namespace wrinkle::cli
