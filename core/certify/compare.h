// One material on both back ends, point by point.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cpu/evaluate.h"
#include "glsl/emit.h"
#include "image/mips.h"

namespace wrinkle::certify {

using ImageOf = std::function<const MipChain&(const std::string& file)>;

// values[output][point * lanes + lane]
using Values = std::vector<std::vector<double>>;

size_t lanes_of(const Module& module, size_t output);

// Nothing, with the reason in `why`, when a limit of the evaluator is met.
template <class T>
std::optional<Values> on_cpu(const Module& module, const PointSet& points, const ImageOf& images,
                             std::string& why);

// Through generated GLSL, by a context that is current. Nothing, with the reason in `why`, when the
// text does not compile.
Shader given_text(const Module& module);  // function form, differentials given
std::optional<Values> on_gpu(const Shader& shader, const PointSet& points, const ImageOf& images,
                             std::string& why);

// Two results at one point, further apart than is allowed.
struct Difference {
    size_t output = 0;
    size_t point = 0;
    std::string a, b, precise;  // "0.25" or "(1, 0, 0)"
    std::string allowed;        // "0.05 degrees", "0.00012, 1e-4 of the range"
};

struct Comparison {
    size_t values = 0;    // compared, a vector counts once
    size_t unstable = 0;  // left out: four ulp of the inputs change the result beyond tolerance
    size_t different = 0;
    std::optional<Difference> first;
};

// `a` and `b` by the rules of parity: normals to 0.05 degrees, other values to 1e-4 of their range.
// `precise` in double says the range, and at `nudged` points which are unstable.
struct Judge {
    const Module* module = nullptr;
    Values precise;
    std::vector<Values> nudged;

    Comparison compare(const Values& a, const Values& b) const;
};
// Nothing, with the reason in `why`, when a limit of the evaluator is met.
std::optional<Judge> make_judge(const Module& module, const PointSet& points, const ImageOf& images,
                                std::string& why);

// "0.25", or "(1, 0, 0)" of several lanes.
std::string words(const double* values, size_t lanes);

}  // namespace wrinkle::certify
