// Evaluates a material on CPU and GPU and compares the results point by point.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cpu/evaluate.h"
#include "emit/emit.h"
#include "image/mips.h"

namespace wrinkle::certify {

using ImageOf = std::function<const MipChain&(const std::string& file)>;

// Results: values[output][point * lanes + lane], lanes = lanes_of(module, output).
using Values = std::vector<std::vector<double>>;

size_t lanes_of(const Module& module, size_t output);

// Evaluates in T: float or double. Returns std::nullopt and sets `why` if a limit of the evaluator
// is exceeded.
template <class T>
std::optional<Values> on_cpu(const Module& module, const PointSet& points, const ImageOf& images,
                             std::string& why);

// Emits GLSL in function form with given differentials.
Shader given_text(const Module& module);
// Runs generated GLSL. Precondition: a context is current. Returns std::nullopt and sets `why` if
// the source has problems or does not run.
std::optional<Values> on_gpu(const Shader& shader, const PointSet& points, const ImageOf& images,
                             std::string& why);

// Two results at one point that differ by more than the tolerance.
struct Difference {
    size_t output = 0;
    size_t point = 0;
    std::string a, b, precise;  // values as words() formats them
    std::string allowed;        // "0.05 degrees", "0.00012, 1e-4 of the range"
};

struct Comparison {
    size_t values = 0;    // all values, unstable ones included; a vector counts once
    size_t unstable = 0;  // not compared: nudged inputs change them beyond tolerance
    size_t different = 0;
    std::optional<Difference> first;
};

// Reference results for comparisons with the parity tolerances: normals to 0.05 degrees, other
// values to 1e-4 of the range of their output in `precise`. A value is unstable if a `nudged`
// result differs from `precise` by more than the tolerance. The module must outlive this object.
struct Reference {
    const Module* module = nullptr;
    Values precise;              // in double
    std::vector<Values> nudged;  // in double, with inputs moved by 4 float ulp

    Comparison compare(const Values& a, const Values& b) const;
};
// Returns std::nullopt and sets `why` if a limit of the evaluator is exceeded.
std::optional<Reference> make_reference(const Module& module, const PointSet& points,
                                        const ImageOf& images, std::string& why);

// Returns the shortest decimal of the value rounded to float.
std::string brief(double value);
// Returns "0.25", or "(1, 0, 0)" for several components.
std::string words(const double* values, size_t lanes);

}  // namespace wrinkle::certify
