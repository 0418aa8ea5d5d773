// One material on both back ends, point by point.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cpu/evaluate.h"
#include "glsl/emit.h"
#include "image/mips.h"

namespace wrinkle::test {

using ImageOf = std::function<const MipChain&(const std::string& file)>;

// values[output][point * lanes + lane]
using Values = std::vector<std::vector<double>>;

template <class T>
Values on_cpu(const Module& module, const PointSet& points, const ImageOf& images);

// Through generated GLSL, by a context that is current. Empty, with a test failure, when the text
// does not compile.
Values on_gpu(const Module& module, const PointSet& points, const ImageOf& images);
Values on_gpu(const Shader& shader, const PointSet& points, const ImageOf& images);

struct Comparison {
    size_t values = 0;    // compared, a vector counts once
    size_t unstable = 0;  // left out: four ulp of the inputs change the result beyond tolerance
    size_t different = 0;
    std::string first;  // the first difference in words
};

// `a` and `b` by the rules of parity: normals to 0.05 degrees, other values to 1e-4 of their range.
// `precise` in double says the range, and at `nudged` points which are unstable.
struct Judge {
    const Module* module = nullptr;
    Values precise;
    std::vector<Values> nudged;

    Comparison compare(const Values& a, const Values& b) const;
};
Judge make_judge(const Module& module, const PointSet& points, const ImageOf& images);

}  // namespace wrinkle::test
