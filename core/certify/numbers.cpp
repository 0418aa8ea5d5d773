#include <algorithm>
#include <cmath>

#include "certify/checks.h"
#include "certify/compare.h"
#include "certify/points.h"

namespace wrinkle::certify {
namespace {

// Reports the first non-finite number of each output; `side` names the back end.
void expect_finite(const Trial& trial, const Values& values, const std::string& side) {
    const Module& module = trial.subject.compiled.module;
    for (size_t output = 0; output < values.size(); ++output) {
        const std::vector<double>& numbers = values[output];
        const auto bad =
            std::ranges::find_if(numbers, [](double number) { return !std::isfinite(number); });
        if (bad == numbers.end()) continue;
        const size_t point = static_cast<size_t>(bad - numbers.begin()) / lanes_of(module, output);
        trial.add("finite", port_of(module.outputs[output].name),
                  "where " + std::string(degenerate_words(point)) + ", it is " +
                      (std::isnan(*bad) ? "not a number" : "infinite") + " (" + side + ")",
                  "guard what can be 0: divide(), safe roots and normalize() of the SDK do; "
                  "operator / does not");
    }
}

void finite(const Trial& trial) {
    static const PointSet points = degenerate_points();
    const Module& module = trial.subject.compiled.module;
    std::string why;
    const auto add = [&](const std::optional<Values>& values, const char* side) {
        if (values) return expect_finite(trial, *values, side);
        trial.report.add({"finite", "", why, "", trial.subject.text});
    };
    add(on_cpu<float>(module, points, test_image, why), "in float");
    add(on_cpu<double>(module, points, test_image, why), "in double");
    if (trial.context.gpu) add(on_gpu(given_text(module), points, test_image, why), "on the GPU");
}

void uniforms(const Trial& trial) {
    Diagnostics diagnostics;
    const Compiled baked =
        compile(trial.subject.project, trial.context, {.uniform = false}, diagnostics);
    if (!baked.ok) return;  // reported by check_text()
    static const PointSet points = random_points(60, 37);
    std::string why;
    const auto a = on_cpu<double>(baked.module, points, test_image, why);
    const auto b = on_cpu<double>(trial.subject.compiled.module, points, test_image, why);
    if (!a || !b) return trial.report.add({"uniform", "", why, "", trial.subject.text});
    for (size_t output = 0; output < a->size(); ++output)
        for (size_t k = 0; k < (*a)[output].size(); ++k) {
            const double x = (*a)[output][k], y = (*b)[output][k];
            const double allowed = 1e-9 * (1 + std::fabs(y));
            if (std::fabs(x - y) <= allowed) continue;
            trial.add("uniform", port_of(baked.module.outputs[output].name),
                      "at point " + std::to_string(k / lanes_of(baked.module, output)) +
                          ", it is " + brief(x) + " with its numbers in the text, " + brief(y) +
                          " with uniforms; " + brief(allowed) + " apart are allowed",
                      "build() may not look at the value of an input, only compute with it");
            break;
        }
}

}  // namespace

void check_finite(const NodeType& type, const CertifyContext& context, Report& report) {
    each_trial(type, {Inputs::defaults, Inputs::zeros, Inputs::wires}, 17, context, report, finite);
}

void check_uniforms(const NodeType& type, const CertifyContext& context, Report& report) {
    each_trial(type, {Inputs::defaults, Inputs::zeros, Inputs::mixed}, 43, context, report,
               uniforms);
}

}  // namespace wrinkle::certify
