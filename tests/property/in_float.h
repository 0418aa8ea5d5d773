// Evaluates the outputs of a material in float, as a shader computes them: core/cpu on one point.
#pragma once

#include "cpu/evaluate.h"
#include "property/material.h"

namespace wrinkle::test {

class InFloat {
public:
    explicit InFloat(const Expanded& material);

    // Inputs are rounded to float; missing inputs are 0.
    dvec3 vector(size_t output, const Surroundings& around) const;

private:
    Program program_;
    std::vector<InputNeed> needs_;
};

}  // namespace wrinkle::test
