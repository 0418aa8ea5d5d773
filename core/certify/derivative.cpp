#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.h"
#include "certify/checks.h"
#include "certify/compare.h"
#include "certify/points.h"
#include "ir/derive.h"

namespace wrinkle::certify {
namespace {

constexpr double step = 1e-4;  // pixels
constexpr size_t point_count = 200;
constexpr size_t least_smooth_share = 50;  // one in so many may be at a jump or a kink

double largest(const std::vector<double>& values) {
    double size = 0;
    for (const double each : values)
        size = std::max(size, std::fabs(each));
    return size;
}

// Central differences at two steps: where they disagree by more than the rounding of the values, there
// is a jump or a kink.
struct Slope {
    double value;
    bool smooth;
};
Slope slope_of(double wide, double narrow, double scale, double rounding) {
    const double size = std::max(std::fabs(narrow), 1e-3 * scale);
    return {(4 * narrow - wide) / 3, std::fabs(wide - narrow) <= 1e-5 * size + rounding};
}

// Of a quotient of differences: a few hundred units in the last place of the values.
double rounding_of(const std::vector<double>& values) {
    return 256 * std::numeric_limits<double>::epsilon() * largest(values) / step;
}

// The numbers among the outputs (a normal is constant under differentiation), each followed by its
// derived change to the next pixel in x.
Module with_derivatives(const Module& source) {
    Module module = source;
    module.outputs.clear();
    Direction direction = screen_direction(module, Variant::dx, false);
    for (const ModuleOutput& output : source.outputs) {
        const bool number = output.port_type != WR_PORT_normal &&
                            output.port_type != WR_PORT_gradient &&
                            output.port_type != WR_PORT_derivative;
        if (!number) continue;
        module.outputs.push_back(output);
        const Id tangent = direction.tangent_or_zero(output.value);
        module.outputs.push_back({output.name + " derived", output.port_type, tangent});
    }
    return module;
}

// Values here, and half a step and a whole one to either side.
struct Around {
    Values here, right, left, near_right, near_left;
};
std::optional<Around> around(const Module& module, std::string& why) {
    static const PointSet points = random_points(point_count, 23);
    const auto at = [&](double pixels) {
        return on_cpu<double>(module, moved_in_x(points, pixels), test_image, why);
    };
    auto here = at(0);
    if (!here) return {};
    return Around{std::move(*here), *at(step), *at(-step), *at(step / 2), *at(-step / 2)};
}

class DerivativeCheck {
public:
    DerivativeCheck(const NodeType& type, const Bench& bench, Report& report)
        : type_(type), bench_(bench), report_(report) {}

    void run(Inputs inputs) {
        const Subject subject = compile_around(type_, inputs, 31, bench_);
        if (!subject.compiled.ok || !subject.compiled.module.resources.empty()) return;
        const Module module = with_derivatives(subject.compiled.module);
        if (module.outputs.empty()) return;
        std::string why;
        const auto values = around(module, why);
        if (!values)
            return report_.add({"derivative", "", why, "fewer iterations of loops", subject.text});
        for (size_t pair = 0; pair < module.outputs.size(); pair += 2)
            compare(module, pair, *values, inputs, subject);
    }

private:
    void compare(const Module& module, size_t pair, const Around& values, Inputs inputs,
                 const Subject& subject) {
        const std::vector<double>& derived = values.here[pair + 1];
        const double scale = largest(derived), rounding = rounding_of(values.here[pair]);
        size_t kinks = 0;
        for (size_t k = 0; k < derived.size(); ++k) {
            const double wide = (values.right[pair][k] - values.left[pair][k]) / (2 * step);
            const double narrow = (values.near_right[pair][k] - values.near_left[pair][k]) / step;
            const Slope slope = slope_of(wide, narrow, scale, rounding);
            kinks += slope.smooth ? 0 : 1;
            report_.kinks += slope.smooth ? 0 : 1;
            report_.derivatives += slope.smooth ? 1 : 0;
            const double allowed =
                1e-4 * std::max(std::fabs(slope.value), 1e-3 * scale) + 1e-9 + rounding;
            if (slope.smooth && !(std::fabs(derived[k] - slope.value) <= allowed))
                wrong(port_of(module.outputs[pair].name), k / lanes_of(module, pair), derived[k],
                      slope.value, allowed, inputs, subject);
        }
        if (least_smooth_share * kinks > derived.size())
            jumps(port_of(module.outputs[pair].name), kinks, derived.size(), inputs, subject);
    }

    void wrong(const std::string& port, size_t point, double derived, double differences,
               double allowed, Inputs inputs, const Subject& subject) {
        report_.add({"derivative", port,
                     std::string(words(inputs)) + ", at point " + std::to_string(point) +
                         ", it changes by " + shortest(static_cast<float>(differences)) +
                         " a pixel, its derivative is " + shortest(static_cast<float>(derived)) +
                         "; " + shortest(static_cast<float>(allowed)) + " apart are allowed",
                     "floor, ceil, step, integers and detach() have derivative 0: use them on what "
                     "is constant around a point",
                     subject.text});
    }

    void jumps(const std::string& port, size_t kinks, size_t all, Inputs inputs,
               const Subject& subject) {
        report_.add({"derivative", port,
                     std::string(words(inputs)) + ", " + std::to_string(kinks) + " of " +
                         std::to_string(all) +
                         " numbers lie on a jump or a kink, where there is no slope; one in " +
                         std::to_string(least_smooth_share) + " is allowed",
                     "make it smooth, or fade it out where it is finer than a pixel: fwidth()",
                     subject.text});
    }

    const NodeType& type_;
    const Bench& bench_;
    Report& report_;
};

}  // namespace

void check_derivatives(const NodeType& type, const Bench& bench, Report& report) {
    DerivativeCheck check(type, bench, report);
    for (const Inputs inputs : {Inputs::defaults, Inputs::wires, Inputs::mixed})
        check.run(inputs);
}

}  // namespace wrinkle::certify
