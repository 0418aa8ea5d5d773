// The text that eval writes: a graph's outputs at its points as JSON, CSV or NPY.
//
//   json  "points": [{"normal": [0, 0, 1], "height": 0.5}, ...]; null for what is not finite
//   csv   normal.x,normal.y,normal.z,height and a line for each point; nan, inf, -inf
//   npy   records of the same names (cli/npy.h), <f4, with double precision <f8
//
// Numbers read back as the same value of their precision.
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

    // The next points, all of them in the end; of no points once.
    void add(size_t count, const std::vector<OutputColumn>& columns);
    std::string take();

private:
    void begin(const std::vector<OutputColumn>& columns);
    void add_csv(size_t point, const std::vector<OutputColumn>& columns);
    void add_record(size_t point, const std::vector<OutputColumn>& columns);

    EvalForm form_;
    Precision precision_;
    size_t points_, done_ = 0;
    bool begun_ = false;
    std::string text_;
};

}  // namespace wrinkle::cli
