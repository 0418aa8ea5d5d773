#include "certify/checks.h"
#include "certify/compare.h"
#include "certify/points.h"

namespace wrinkle::certify {
namespace {

constexpr size_t parity_points = 300;
// At most one value in this many may be unstable. Steep edges are unstable without being wrong, but
// if most values are unstable the comparison proves nothing.
constexpr size_t min_stable_share = 2;

class ParityCheck {
public:
    ParityCheck(const NodeType& type, const CertifyContext& context, Report& report)
        : type_(type), context_(context), report_(report) {}

    void run(Inputs inputs, unsigned seed) {
        const Subject subject = compile_harness(type_, inputs, seed, context_);
        if (!subject.compiled.ok) return;
        static const PointSet points = random_points(parity_points, 7);
        const Module& module = subject.compiled.module;
        std::string why;
        const auto judge = make_judge(module, points, test_image, why);
        if (!judge)
            return report_.add({"precision", "", why, "fewer iterations of loops", subject.text});
        const Values cpu = *on_cpu<float>(module, points, test_image, why);
        const Comparison comparison = judge->compare(cpu, judge->precise);
        report_.values += comparison.values;
        report_.unstable += comparison.unstable;
        if (comparison.first)
            differs("precision", "float", "double", *comparison.first, inputs, subject);
        if (min_stable_share * comparison.unstable > comparison.values)
            unstable(comparison, inputs, subject);
        if (context_.gpu) gpu(*judge, cpu, points, inputs, subject);
    }

private:
    void gpu(const Judge& judge, const Values& cpu, const PointSet& points, Inputs inputs,
             const Subject& subject) {
        std::string why;
        const auto gpu = on_gpu(given_text(subject.compiled.module), points, test_image, why);
        if (!gpu)
            return report_.add({"gpu", "", "the driver does not run it: " + why, "", subject.text});
        const Comparison comparison = judge.compare(cpu, *gpu);
        if (comparison.first)
            differs("gpu", "the CPU", "the GPU", *comparison.first, inputs, subject);
    }

    void differs(const char* check, const std::string& a, const std::string& b,
                 const Difference& first, Inputs inputs, const Subject& subject) {
        std::string message = words(inputs) + ", at point " + std::to_string(first.point) +
                              ", it is " + first.a + " in " + a + ", " + first.b + " in " + b;
        if (first.precise != first.b) message += ", precisely " + first.precise;
        report_.add({check, port_of(subject.compiled.module.outputs[first.output].name),
                     message + "; " + first.allowed + " apart are allowed",
                     "keep numbers small (fract() before a large factor) and away from what "
                     "plugin.h leaves undefined",
                     subject.text});
    }

    void unstable(const Comparison& comparison, Inputs inputs, const Subject& subject) {
        report_.add({"precision", "",
                     words(inputs) + ", " + std::to_string(comparison.unstable) + " of " +
                         std::to_string(comparison.values) +
                         " values hang on the last bits of their inputs; one in " +
                         std::to_string(min_stable_share) + " is allowed",
                     "move jumps away from where inputs often are, or make them smooth",
                     subject.text});
    }

    const NodeType& type_;
    const CertifyContext& context_;
    Report& report_;
};

}  // namespace

void check_parity(const NodeType& type, const CertifyContext& context, Report& report) {
    ParityCheck check(type, context, report);
    unsigned seed = 1;
    for (const Inputs inputs : {Inputs::defaults, Inputs::numbers, Inputs::wires, Inputs::mixed})
        check.run(inputs, seed++);
}

}  // namespace wrinkle::certify
