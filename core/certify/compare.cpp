#include "certify/compare.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/normals.h"
#include "base/text.h"
#include "certify/points.h"
#include "gpu/point_runner.h"
#include "ir/module.h"

namespace wrinkle::certify {
namespace {

constexpr double normal_tolerance_deg = 0.05;
constexpr double value_tolerance = 1e-4;  // relative to the range
constexpr unsigned nudges = 4;

std::vector<Texture> textures_of(const Module& module, const ImageOf& images) {
    std::vector<Texture> textures;
    for (const Resource& resource : module.resources)
        textures.emplace_back(images(resource.file), resource.options);
    return textures;
}

// Returns the distance of two results in units of the tolerance. Infinity if a value is not finite
// or a normal has no direction.
double distance(const double* a, const double* b, size_t lanes, bool normal, double range) {
    double worst = 0;
    for (size_t i = 0; i < lanes; ++i) {
        if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return INFINITY;
        worst = std::max(worst, std::fabs(a[i] - b[i]));
    }
    if (!normal || worst == 0) return worst / (value_tolerance * range);
    const double degrees = degrees_between(a, b);
    return std::isnan(degrees) ? INFINITY : degrees / normal_tolerance_deg;
}

// Lower limit of the range, so that a variation that is only rounding error (for example of unit
// vectors) is within tolerance.
constexpr double min_range = 5e-3;

// Returns max - min; for constants the largest magnitude. At least min_range.
double range_of(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double size = std::max(std::fabs(*low), std::fabs(*high));
    const double range = *high - *low;
    return std::max(range > 1e-6 * size ? range : size, min_range);
}

bool is_normal(const Module& module, size_t output) {
    return module.outputs[output].port_type == WR_PORT_normal;
}

std::string allowed_words(bool normal, double range) {
    if (normal) return shortest(normal_tolerance_deg) + " degrees";
    return brief(value_tolerance * range) + ", 1e-4 of the range " + brief(range);
}

std::vector<float> floats(const std::vector<double>& values) {
    return {values.begin(), values.end()};
}

gpu::PointJob job_of(const Shader& shader, const PointSet& points, const ImageOf& images) {
    gpu::PointJob job = gpu::point_job_from(shader);
    job.points = points.count;
    for (const MemberInfo& member : shader.reflection.members)
        job.attributes.push_back({member.name, info(member.type).lanes,
                                  floats(points.at(member.input, member.variant))});
    for (const SamplerInfo& sampler : job.samplers)
        job.images.push_back({sampler.file, &images(sampler.file)});
    return job;
}

}  // namespace

size_t lanes_of(const Module& module, size_t output) {
    return info(module.type(module.outputs[output].value)).lanes;
}

template <class T>
std::optional<Values> on_cpu(const Module& module, const PointSet& points, const ImageOf& images,
                             std::string& why) {
    why.clear();
    const Program program = compile_program(module, why);
    if (!why.empty()) return {};
    Results results = make_results(program, points.count);
    evaluate<T>(program, points, textures_of(module, images), 0, points.count, results);
    return results.values;
}
template std::optional<Values> on_cpu<float>(const Module&, const PointSet&, const ImageOf&,
                                             std::string&);
template std::optional<Values> on_cpu<double>(const Module&, const PointSet&, const ImageOf&,
                                              std::string&);

Shader given_text(const Module& module) {
    EmitOptions options;
    options.differentials = Differentials::given;
    options.name = "subject";
    return emit(module, options);
}

std::optional<Values> on_gpu(const Shader& shader, const PointSet& points, const ImageOf& images,
                             std::string& why) {
    Diagnostics diagnostics;
    std::optional<gpu::PointResults> results;
    if (shader.problems.empty()) {
        results = gpu::run_points(job_of(shader, points, images), diagnostics);
        why = to_text(diagnostics);
    } else {
        why = shader.problems[0].message;
    }
    if (!results) return {};
    Values values;
    for (size_t k = 0; k < results->size(); ++k) {
        const size_t lanes = info(shader.reflection.outputs[k].type).lanes;
        values.emplace_back();
        for (const auto& pixel : (*results)[k])
            values.back().insert(values.back().end(), pixel.begin(),
                                 pixel.begin() + static_cast<long>(lanes));
    }
    return values;
}

std::optional<Reference> make_reference(const Module& module, const PointSet& points,
                                        const ImageOf& images, std::string& why) {
    Reference reference{&module, {}, {}};
    auto precise = on_cpu<double>(module, points, images, why);
    if (!precise) return {};
    reference.precise = std::move(*precise);
    for (unsigned seed = 0; seed < nudges; ++seed)
        reference.nudged.push_back(*on_cpu<double>(module, nudged(points, seed), images, why));
    return reference;
}

Comparison Reference::compare(const Values& a, const Values& b) const {
    Comparison result;
    for (size_t output = 0; output < precise.size(); ++output) {
        const size_t lanes = lanes_of(*module, output);
        const bool normal = is_normal(*module, output);
        const double range = range_of(precise[output]);
        for (size_t at = 0; at < precise[output].size(); at += lanes) {
            const auto differ = [&](const Values& x, const Values& y) {
                return !(distance(&x[output][at], &y[output][at], lanes, normal, range) <= 1);
            };
            ++result.values;
            if (std::ranges::any_of(nudged,
                                    [&](const Values& each) { return differ(precise, each); }))
                ++result.unstable;
            else if (differ(a, b) && result.different++ == 0)
                result.first = {output,
                                at / lanes,
                                words(&a[output][at], lanes),
                                words(&b[output][at], lanes),
                                words(&precise[output][at], lanes),
                                allowed_words(normal, range)};
        }
    }
    return result;
}

std::string brief(double value) {
    return shortest(static_cast<float>(value));
}

std::string words(const double* values, size_t lanes) {
    const std::string text = joined(std::span(values, lanes), ", ", brief);
    return lanes == 1 ? text : "(" + text + ")";
}

}  // namespace wrinkle::certify
