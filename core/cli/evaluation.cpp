#include "cli/evaluation.h"

#include <algorithm>
#include <cmath>

#include "mesh/mesh.h"

namespace wrinkle::cli {
namespace {

bool within_float(const PointList& points, const PointSet& set, const Program& program,
                  Diagnostics& diagnostics) {
    const std::vector<FloatOverflow> beyond = float_overflow(program, set);
    for (const FloatOverflow& each : beyond)
        points.report(each.point, RuleId::precision_loss, Severity::error, each.message(),
                      "--precision double does", diagnostics);
    return beyond.empty();
}

// Length of the longer differential (dx, dy) of a value at point `k`; 0 if it is not read.
double change_of(const PointSet& set, SurfaceInput input, size_t k) {
    double most = 0;
    for (const Variant variant : {Variant::dx, Variant::dy}) {
        const std::vector<double>& values = set.at(input, variant);
        const size_t lanes = lanes_of({input, variant});
        double square = 0;
        for (size_t i = 0; !values.empty() && i < lanes; ++i)
            square += values[k * lanes + i] * values[k * lanes + i];
        most = std::max(most, std::sqrt(square));
    }
    return most;
}

// Below this product of lengths, a frame derived from uv differentials fades, also in double
// precision (core/ir/gradient_frame.cpp).
constexpr double min_change_product = 1e-18;

void warn_of_small_changes(const PointList& points, const PointSet& set, Diagnostics& diagnostics) {
    for (int i = 0; i < static_cast<int>(max_uv_sets); ++i) {
        const auto uv = static_cast<SurfaceInput>(static_cast<int>(SurfaceInput::uv0_) + i);
        if (set.at(uv, Variant::dx).empty()) continue;
        for (size_t k = 0; k < set.count; ++k) {
            const double product =
                change_of(set, SurfaceInput::position_, k) * change_of(set, uv, k);
            if (product > 0 && product < min_change_product)
                points.report(k, RuleId::precision_loss, Severity::warning,
                              "the changes of position and " + name_of({uv, Variant::value}) +
                                  " are so small that a frame 'derived' of them fades",
                              "lengths whose product is above 1e-18", diagnostics);
        }
    }
}

// Lengths outside this range have a square that is zero or infinite in single precision.
constexpr double min_length = 1e-18, max_length = 1e18;

void warn_of_lost_normals(const PointList& points, const PointSet& set, Diagnostics& diagnostics) {
    const std::vector<double>& normals = set.at(SurfaceInput::normal_, Variant::value);
    for (size_t k = 0; k < normals.size() / 3; ++k) {
        const double* n = normals.data() + 3 * k;
        const double length = std::hypot(n[0], n[1], n[2]);
        if (length > 0 && (length < min_length || length > max_length))
            points.report(k, RuleId::precision_loss, Severity::warning,
                          "the surface normal's length cannot be squared in single precision",
                          "a length between 1e-18 and 1e18, or --precision double", diagnostics);
    }
}

}  // namespace

std::optional<std::vector<OutputColumn>> evaluate_points(const MaterialRun& run,
                                                         const TextureStore& textures,
                                                         const PointSource& source,
                                                         Precision precision,
                                                         Diagnostics& diagnostics) {
    std::string why;
    const Program program = compile_program(run.compiled.module, why);
    if (!why.empty()) diagnostics.error(RuleId::over_limit, why);
    const Needs needs = needed_inputs(program);
    if (!why.empty() || !source.check(needs, diagnostics)) return {};
    PointSet set;
    if (!source.fill(needs, set, diagnostics)) return {};
    const bool single = precision == Precision::single;
    if (single && !within_float(source.points, set, program, diagnostics)) return {};
    warn_of_small_changes(source.points, set, diagnostics);
    if (single) warn_of_lost_normals(source.points, set, diagnostics);
    return evaluate_columns(program, set, textures.textures_of(run.compiled.module.resources),
                            precision);
}

}  // namespace wrinkle::cli
