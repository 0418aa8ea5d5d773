// A module under construction together with the surface points at which it will be evaluated.
//
// Operands of every type are made of scalar surface inputs, so each point has different values; the
// reference interpreter of tests/ir reads the same points.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "cpu/evaluate.h"
#include "ir/interpret.h"
#include "ir/module.h"
#include "ir/rewrite.h"

namespace wrinkle::test {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<InstructionSet> every_set();  // supported by this machine, the widest last

class Scene {
public:
    explicit Scene(size_t points);

    // A value equal to values[point] at each point. Integers and bools are converted from a float
    // input.
    Id operand(Type type, std::span<const Lanes> values);
    Id scalar(std::span<const double> values);
    // As above, with the numbers make(point).
    template <class Make>
    Id numbers(Make make) {
        std::vector<double> values(points.count);
        for (size_t k = 0; k < values.size(); ++k)
            values[k] = make(k);
        return scalar(values);
    }

    void output(Id value);
    Surroundings at(size_t point) const;

    Module m;
    PointSet points;

private:
    uint32_t used_ = 0;
};

// Evaluates all points in one call. `textures` are indexed by resource.
template <class T>
Results evaluate_all(const Scene& scene, std::span<const Texture> textures = {}) {
    std::string why;
    const Program program = compile_program(explicit_lod(scene.m), why);
    Results results = make_results(program, scene.points.count);
    evaluate<T>(program, scene.points, textures, 0, scene.points.count, results);
    return results;
}

// Compares every output at every point with the interpreter.
void expect_as_interpreted(const Scene& scene, double tolerance);

}  // namespace wrinkle::test
