// Evaluates a material on CPU and GPU and compares the results point by point.
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

// Returns std::nullopt and sets `why` if a limit of the evaluator is exceeded.
template <class T>
std::optional<Values> on_cpu(const Module& module, const PointSet& points, const ImageOf& images,
                             std::string& why);

// on_gpu() runs generated GLSL. Precondition: a context is current. Returns std::nullopt and sets
// `why` if the source has problems or does not run.
Shader given_text(const Module& module);  // function form, differentials given
std::optional<Values> on_gpu(const Shader& shader, const PointSet& points, const ImageOf& images,
                             std::string& why);

// Two results at one point that differ by more than the tolerance.
struct Difference {
    size_t output = 0;
    size_t point = 0;
    std::string a, b, precise;  // "0.25" or "(1, 0, 0)"
    std::string allowed;        // "0.05 degrees", "0.00012, 1e-4 of the range"
};

struct Comparison {
    size_t values = 0;    // all values, unstable ones included; a vector counts once
    size_t unstable = 0;  // skipped: nudged inputs change them beyond tolerance
    size_t different = 0;
    std::optional<Difference> first;
};

// Compares `a` and `b` with the parity tolerances: normals to 0.05 degrees, other values to 1e-4 of
// their range. `precise` holds the results in double and gives the range; a value is unstable if
// one of the `nudged` results (inputs moved by 4 ulp) differs from it by more than the tolerance.
struct Judge {
    const Module* module = nullptr;
    Values precise;
    std::vector<Values> nudged;

    Comparison compare(const Values& a, const Values& b) const;
};
// Returns std::nullopt and sets `why` if a limit of the evaluator is exceeded.
std::optional<Judge> make_judge(const Module& module, const PointSet& points, const ImageOf& images,
                                std::string& why);

std::string brief(double value);  // in single precision
// Returns "0.25", or "(1, 0, 0)" for several components.
std::string words(const double* values, size_t lanes);

}  // namespace wrinkle::certify
