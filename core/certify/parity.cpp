#include "certify/checks.h"
#include "certify/compare.h"
#include "certify/points.h"

namespace wrinkle::certify {
namespace {

constexpr size_t parity_points = 300;
// At most one value in this many may be unstable. Steep edges are unstable without being wrong, but
// if most values are unstable the comparison proves nothing.
constexpr size_t min_stable_share = 2;

void differs(const Trial& trial, const char* check, const std::string& a, const std::string& b,
             const Difference& first) {
    std::string message = "at point " + std::to_string(first.point) + ", it is " + first.a +
                          " in " + a + ", " + first.b + " in " + b;
    if (first.precise != first.b) message += ", precisely " + first.precise;
    trial.add(check, port_of(trial.subject.compiled.module.outputs[first.output].name),
              message + "; " + first.allowed + " apart are allowed",
              "keep numbers small (fract() before a large factor) and away from what "
              "plugin.h leaves undefined");
}

void parity(const Trial& trial) {
    static const PointSet points = random_points(parity_points, 7);
    const Module& module = trial.subject.compiled.module;
    Report& report = trial.report;
    std::string why;
    const auto reference = make_reference(module, points, test_image, why);
    if (!reference)
        return report.add({"precision", "", why, "fewer iterations of loops", trial.subject.text});
    const Values cpu = *on_cpu<float>(module, points, test_image, why);
    const Comparison single = reference->compare(cpu, reference->precise);
    report.values += single.values;
    report.unstable += single.unstable;
    if (single.first) differs(trial, "precision", "float", "double", *single.first);
    if (min_stable_share * single.unstable > single.values)
        trial.add("precision", "",
                  std::to_string(single.unstable) + " of " + std::to_string(single.values) +
                      " values hang on the last bits of their inputs; one in " +
                      std::to_string(min_stable_share) + " is allowed",
                  "move jumps away from where inputs often are, or make them smooth");
    if (!trial.context.gpu) return;
    const auto gpu = on_gpu(given_text(module), points, test_image, why);
    if (!gpu)
        return report.add(
            {"gpu", "", "the driver does not run it: " + why, "", trial.subject.text});
    const Comparison both = reference->compare(cpu, *gpu);
    if (both.first) differs(trial, "gpu", "the CPU", "the GPU", *both.first);
}

}  // namespace

void check_parity(const NodeType& type, const CertifyContext& context, Report& report) {
    unsigned seed = 1;
    for (const Inputs inputs : {Inputs::defaults, Inputs::numbers, Inputs::wires, Inputs::mixed})
        each_trial(type, {inputs}, seed++, context, report, parity);
}

}  // namespace wrinkle::certify
