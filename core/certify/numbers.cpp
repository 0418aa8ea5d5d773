#include <cmath>

#include "certify/checks.h"
#include "certify/compare.h"
#include "certify/points.h"

namespace wrinkle::certify {
namespace {

// Reports the first non-finite number of each output; `side` names the back end.
void expect_finite(const Values& values, const char* side, const Subject& subject, Inputs inputs,
                   Report& report) {
    const Module& module = subject.compiled.module;
    for (size_t output = 0; output < values.size(); ++output)
        for (size_t k = 0; k < values[output].size(); ++k) {
            if (std::isfinite(values[output][k])) continue;
            const size_t point = k / lanes_of(module, output);
            const std::string number = std::isnan(values[output][k]) ? "not a number" : "infinite";
            report.add({"finite", port_of(module.outputs[output].name),
                        words(inputs) + ", where " + std::string(degenerate_words(point)) +
                            ", it is " + number + " (" + side + ")",
                        "guard what can be 0: divide(), safe roots and normalize() of the SDK do; "
                        "operator / does not",
                        subject.text});
            break;
        }
}

void finite(const NodeType& type, Inputs inputs, const CertifyContext& context, Report& report) {
    const Subject subject = compile_harness(type, inputs, 17, context);
    if (!subject.compiled.ok) return;
    static const PointSet points = degenerate_points();
    const Module& module = subject.compiled.module;
    std::string why;
    const auto add = [&](const std::optional<Values>& values, const char* side) {
        if (values) return expect_finite(*values, side, subject, inputs, report);
        report.add({"finite", "", why, "", subject.text});
    };
    add(on_cpu<float>(module, points, test_image, why), "in float");
    add(on_cpu<double>(module, points, test_image, why), "in double");
    if (context.gpu) add(on_gpu(given_text(module), points, test_image, why), "on the GPU");
}

void uniforms(const NodeType& type, Inputs inputs, const CertifyContext& context, Report& report) {
    const Subject subject = compile_harness(type, inputs, 43, context);
    Diagnostics diagnostics;
    if (!subject.compiled.ok) return;
    const Compiled baked = compile(subject.project, context, {.uniform = false}, diagnostics);
    if (!baked.ok) return;  // reported by check_text()
    static const PointSet points = random_points(60, 37);
    std::string why;
    const auto a = on_cpu<double>(baked.module, points, test_image, why);
    const auto b = on_cpu<double>(subject.compiled.module, points, test_image, why);
    if (!a || !b) return report.add({"uniform", "", why, "", subject.text});
    for (size_t output = 0; output < a->size(); ++output)
        for (size_t k = 0; k < (*a)[output].size(); ++k) {
            const double x = (*a)[output][k], y = (*b)[output][k];
            const double allowed = 1e-9 * (1 + std::fabs(y));
            if (std::fabs(x - y) <= allowed) continue;
            report.add({"uniform", port_of(baked.module.outputs[output].name),
                        words(inputs) + ", at point " +
                            std::to_string(k / lanes_of(baked.module, output)) + ", it is " +
                            brief(x) + " with its numbers in the text, " + brief(y) +
                            " with uniforms; " + brief(allowed) + " apart are allowed",
                        "build() may not look at the value of an input, only compute with it",
                        subject.text});
            break;
        }
}

}  // namespace

void check_finite(const NodeType& type, const CertifyContext& context, Report& report) {
    for (const Inputs inputs : {Inputs::defaults, Inputs::zeros, Inputs::wires})
        finite(type, inputs, context, report);
}

void check_uniforms(const NodeType& type, const CertifyContext& context, Report& report) {
    for (const Inputs inputs : {Inputs::defaults, Inputs::zeros, Inputs::mixed})
        uniforms(type, inputs, context, report);
}

}  // namespace wrinkle::certify
