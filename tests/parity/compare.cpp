#include "parity/compare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glslang/validate.h"
#include "gpu/from_glsl.h"
#include "parity/points.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

constexpr double normal_tolerance_deg = 0.05;
constexpr double value_tolerance = 1e-4;  // of the range

size_t lanes_of(const Module& module, size_t output) {
    return info(module.type(module.outputs[output].value)).lanes;
}

std::vector<Texture> textures_of(const Module& module, const ImageOf& images) {
    std::vector<Texture> textures;
    for (const Resource& resource : module.resources)
        textures.emplace_back(images(resource.file), resource.options);
    return textures;
}

// How far two results are apart, 1 being as far as is allowed. Not finite: infinitely far.
double distance(const double* a, const double* b, size_t lanes, bool normal, double range) {
    double worst = normal ? angle_deg(a, b) / normal_tolerance_deg : 0;
    for (size_t i = 0; i < lanes; ++i) {
        if (!std::isfinite(a[i]) || !std::isfinite(b[i])) return INFINITY;
        if (!normal) worst = std::max(worst, std::fabs(a[i] - b[i]) / (value_tolerance * range));
    }
    return worst;
}

// Below it values that vary are rounding: of unit vectors, say.
constexpr double smallest_range = 5e-3;

// A constant has no range; its size stands in.
double range_of(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double size = std::max(std::fabs(*low), std::fabs(*high));
    const double range = *high - *low;
    return std::max(range > 1e-6 * size ? range : size, smallest_range);
}

std::string words(const double* values, size_t lanes) {
    std::string text = "(";
    for (size_t i = 0; i < lanes; ++i)
        text += (i > 0 ? ", " : "") + std::to_string(values[i]);
    return text + ")";
}

std::vector<float> floats(const std::vector<double>& values) {
    std::vector<float> result;
    for (const double value : values)
        result.push_back(static_cast<float>(value));
    return result;
}

}  // namespace

template <class T>
Values on_cpu(const Module& module, const PointSet& points, const ImageOf& images) {
    std::string why;
    const Program program = compile_program(module, why);
    EXPECT_EQ(why, "");
    Results results = make_results(program, points.count);
    evaluate<T>(program, points, textures_of(module, images), 0, points.count, results);
    return results.values;
}
template Values on_cpu<float>(const Module&, const PointSet&, const ImageOf&);
template Values on_cpu<double>(const Module&, const PointSet&, const ImageOf&);

Values on_gpu(const Module& module, const PointSet& points, const ImageOf& images) {
    EmitOptions options;
    options.differentials = Differentials::given;
    options.name = "subject";
    const Shader shader = emit(module, options);
    for (const Problem& problem : shader.problems)
        ADD_FAILURE() << problem.message;
    return on_gpu(shader, points, images);
}

Values on_gpu(const Shader& shader, const PointSet& points, const ImageOf& images) {
    EXPECT_EQ(compile_errors(shader), "");
    gpu::PointJob job = gpu::point_job_from(shader);
    job.points = points.count;
    for (const MemberInfo& member : shader.reflection.members)
        job.attributes.push_back({member.name, info(member.type).lanes,
                                  floats(points.at(member.input, member.variant))});
    for (const gpu::MaterialSampler& sampler : job.samplers)
        job.images.push_back({sampler.file, &images(sampler.file)});
    Diagnostics diagnostics;
    const auto results = gpu::run_points(job, diagnostics);
    if (!results) {
        ADD_FAILURE() << to_text(diagnostics) << shader.source;
        return {};
    }
    Values values;
    for (size_t k = 0; k < results->size(); ++k) {
        const size_t lanes = info(shader.reflection.functions[k].type).lanes;
        values.emplace_back();
        for (const auto& pixel : (*results)[k])
            values.back().insert(values.back().end(), pixel.begin(),
                                 pixel.begin() + static_cast<long>(lanes));
    }
    return values;
}

Judge make_judge(const Module& module, const PointSet& points, const ImageOf& images) {
    Judge judge{&module, on_cpu<double>(module, points, images), {}};
    for (unsigned seed = 0; seed < 4; ++seed)
        judge.nudged.push_back(on_cpu<double>(module, nudged(points, seed), images));
    return judge;
}

Comparison Judge::compare(const Values& a, const Values& b) const {
    Comparison result;
    for (size_t output = 0; output < precise.size(); ++output) {
        const size_t lanes = lanes_of(*module, output);
        const bool normal = module->outputs[output].port_type == WR_PORT_normal;
        const double range = range_of(precise[output]);
        for (size_t point = 0; point * lanes < precise[output].size(); ++point) {
            const auto apart = [&](const Values& x, const Values& y) {
                return distance(&x[output][point * lanes], &y[output][point * lanes], lanes, normal,
                                range);
            };
            ++result.values;
            if (std::any_of(nudged.begin(), nudged.end(),
                            [&](const Values& each) { return !(apart(precise, each) <= 1); })) {
                ++result.unstable;
                continue;
            }
            if (apart(a, b) <= 1) continue;
            if (result.different++ == 0)
                result.first = module->outputs[output].name + " at point " + std::to_string(point) +
                               ": " + words(&a[output][point * lanes], lanes) + " and " +
                               words(&b[output][point * lanes], lanes) + ", precisely " +
                               words(&precise[output][point * lanes], lanes) + ", range " +
                               std::to_string(range);
        }
    }
    return result;
}

}  // namespace wrinkle::test
