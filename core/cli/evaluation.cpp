#include "cli/evaluation.h"

#include <cmath>

#include "base/text.h"

namespace wrinkle::cli {
namespace {

bool within_float(const std::vector<Point>& points, const PointSet& set, const Program& program,
                  Diagnostics& diagnostics) {
    const std::vector<BeyondFloat> beyond = beyond_float(program, set);
    for (const BeyondFloat& each : beyond)
        report_at(points[each.point].source, points[each.point].name + ": " + each.message(),
                  "--precision double does", diagnostics);
    return beyond.empty();
}

std::string number_json(double value, Precision precision) {
    if (!std::isfinite(value)) return "null";
    return precision == Precision::single ? shortest(static_cast<float>(value)) : shortest(value);
}

}  // namespace

std::optional<std::vector<OutputColumn>> evaluate_at(const MaterialRun& run,
                                                     const TextureStore& textures,
                                                     const std::vector<Point>& points,
                                                     Precision precision,
                                                     Diagnostics& diagnostics) {
    std::string why;
    const Program program = compile_program(run.compiled.module, why);
    if (!why.empty()) diagnostics.error(why);
    if (!why.empty() || !all_given(points, program, diagnostics)) return {};
    const PointSet set = point_set(points, program);
    if (precision == Precision::single && !within_float(points, set, program, diagnostics))
        return {};
    const std::vector<Texture> images = textures.textures_of(run.compiled.module.resources);
    return evaluate_columns(program, set, images, precision);
}

std::string values_json(const std::vector<OutputColumn>& columns, size_t point,
                        Precision precision) {
    std::string text = "{";
    for (const OutputColumn& column : columns) {
        text += (text.size() > 1 ? ", " : "") + json_quoted(column.name) + ": ";
        if (column.lanes > 1) text += "[";
        for (size_t lane = 0; lane < column.lanes; ++lane) {
            const double value = column.values[point * column.lanes + lane];
            text += (lane > 0 ? ", " : "") + number_json(value, precision);
        }
        if (column.lanes > 1) text += "]";
    }
    return text + "}";
}

}  // namespace wrinkle::cli
