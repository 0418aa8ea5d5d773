#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "certify/checks.h"
#include "certify/compare.h"
#include "certify/points.h"
#include "ir/derive.h"
#include "ir/expand.h"
#include "ir/rewrite.h"
#include "ir/value.h"

namespace wrinkle::certify {
namespace {

constexpr double step = 1e-4;  // pixels
constexpr size_t derivative_points = 200;
constexpr size_t min_smooth_share = 50;  // at most one in this many at a jump or a kink

double largest(const std::vector<double>& values) {
    double size = 0;
    for (const double each : values)
        size = std::max(size, std::fabs(each));
    return size;
}

// Central differences at two step sizes; `value` is their Richardson extrapolation. `smooth` is
// false if they differ by more than 1e-5 of their size plus rounding error: a jump or a kink.
struct Slope {
    double value;
    bool smooth;
};
Slope slope_of(double wide, double narrow, double scale, double rounding) {
    const double size = std::max(std::fabs(narrow), 1e-3 * scale);
    return {(4 * narrow - wide) / 3, std::fabs(wide - narrow) <= 1e-5 * size + rounding};
}

// Rounding error of a difference quotient: 256 ulp of the largest value, divided by the step.
double rounding_of(const std::vector<double>& values) {
    return 256 * std::numeric_limits<double>::epsilon() * largest(values) / step;
}

bool is_number(const ModuleOutput& output) {
    return output.port_type != WR_PORT_normal && output.port_type != WR_PORT_gradient &&
           output.port_type != WR_PORT_derivative;
}

// Outputs are stored in groups of three.
enum Column : size_t { value, derived, bump, columns };

// Returns a module with three outputs per number output (a normal is constant under
// differentiation): the value, its derivative per pixel in x, and the same derivative with detached
// values constant, as in bumps.
Module with_derivatives(const Subject& subject, const CertifyContext& context) {
    Diagnostics diagnostics;
    const Types types(subject.project, context.registry);
    Module lowered = lower(subject.project, types, {}, diagnostics).module;
    const std::vector<ModuleOutput> outputs = std::exchange(lowered.outputs, {});
    for (const ModuleOutput& output : outputs) {
        if (!is_number(output)) continue;
        lowered.outputs.push_back(output);
        lowered.outputs.push_back(output);
        lowered.outputs.push_back(
            {output.name, output.port_type, op(Op::ddx_, Value{&lowered, output.value}).id});
    }
    const ExpandOptions options{.back_faces = subject.project.top().back_face_rule()};
    Module module = explicit_lod(expand(std::move(lowered), options));
    ForwardDiff direction = direction_along(module, DiffAxis::screen_x);
    for (size_t k = 0; k < module.outputs.size(); k += columns)
        module.outputs[k + derived].value = direction.jvp_or_zero(module.outputs[k + value].value);
    return module;
}

// Values at the points, and one step and half a step to either side in x.
struct Around {
    Values here, right, left, near_right, near_left;
};
std::optional<Around> around(const Module& module, std::string& why) {
    static const PointSet points = random_points(derivative_points, 23);
    const auto at = [&](double pixels) {
        return on_cpu<double>(module, moved_in_x(points, pixels), test_image, why);
    };
    auto here = at(0);
    if (!here) return {};
    return Around{std::move(*here), *at(step), *at(-step), *at(step / 2), *at(-step / 2)};
}

// A derivative by differences.
struct Expected {
    size_t point;
    double value;
    double allowed;
    bool near(double derived) const { return std::fabs(derived - value) <= allowed; }
};

void differs(const Trial& trial, const std::string& port, const Expected& expected, double found,
             bool detached) {
    trial.add(
        detached ? "detach" : "derivative", port,
        "at point " + std::to_string(expected.point) + ", it changes by " + brief(expected.value) +
            " a pixel, its derivative is " + brief(found) + "; " + brief(expected.allowed) +
            " apart are allowed",
        detached ? "a bump leaves out a detached value: detach() only a value that is constant "
                   "around a point, or pass --allow detach if this is intended"
                 : "floor, ceil, step and integers have derivative 0: use them on what is constant "
                   "around a point");
}

// Compares the derivative of one output.
void compare(const Trial& trial, const Module& module, size_t output, const Around& around) {
    const std::string port = port_of(module.outputs[output].name);
    const std::vector<double>& here = around.here[output + derived];
    const double scale = largest(here), rounding = rounding_of(around.here[output]);
    // "detach" is checked for constant inputs only: with varying inputs, values detached for
    // filtering (the pixel size) vary too.
    const bool bumps = module.outputs[output].port_type == WR_PORT_height &&
                       (trial.inputs == Inputs::defaults || trial.inputs == Inputs::numbers);
    size_t kinks = 0;
    for (size_t k = 0; k < here.size(); ++k) {
        const double wide = (around.right[output][k] - around.left[output][k]) / (2 * step);
        const double narrow = (around.near_right[output][k] - around.near_left[output][k]) / step;
        const Slope slope = slope_of(wide, narrow, scale, rounding);
        kinks += slope.smooth ? 0 : 1;
        if (!slope.smooth) continue;
        const Expected expected{
            k / lanes_of(module, output), slope.value,
            1e-4 * std::max(std::fabs(slope.value), 1e-3 * scale) + 1e-9 + rounding};
        const double of_bump = around.here[output + bump][k];
        if (!expected.near(here[k]))
            differs(trial, port, expected, here[k], false);
        else if (bumps && !expected.near(of_bump))
            differs(trial, port, expected, of_bump, true);
    }
    trial.report.kinks += kinks;
    trial.report.derivatives += here.size() - kinks;
    if (min_smooth_share * kinks > here.size())
        trial.add("derivative", port,
                  std::to_string(kinks) + " of " + std::to_string(here.size()) +
                      " numbers lie on a jump or a kink, where there is no slope; one in " +
                      std::to_string(min_smooth_share) + " is allowed",
                  "make it smooth, or fade it out where it is finer than a pixel: fwidth()");
}

void derivatives(const Trial& trial) {
    if (!trial.subject.compiled.module.resources.empty()) return;
    const Module module = with_derivatives(trial.subject, trial.context);
    if (module.outputs.empty()) return;
    std::string why;
    const auto values = around(module, why);
    if (!values)
        return trial.report.add(
            {"derivative", "", why, "fewer iterations of loops", trial.subject.text});
    for (size_t k = 0; k < module.outputs.size(); k += columns)
        compare(trial, module, k, *values);
}

}  // namespace

void check_derivatives(const NodeType& type, const CertifyContext& context, Report& report) {
    each_trial(type, {Inputs::defaults, Inputs::numbers, Inputs::wires, Inputs::mixed}, 31, context,
               report, derivatives);
}

}  // namespace wrinkle::certify
