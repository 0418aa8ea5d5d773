#include "cli/evaluation.h"

#include <cmath>

#include "base/text.h"

namespace wrinkle::cli {
namespace {

// In single precision a number beyond float is infinite, which no surface has.
bool within_float(const std::vector<Point>& points, const Program& program,
                  Diagnostics& diagnostics) {
    bool fine = true;
    const std::vector<InputNeed> needs = needed_inputs(program);
    for (const Point& point : points)
        for (const InputNeed& need : needs) {
            const PointKey key{need.input, need.variant};
            for (const double lane : point[key].lanes) {
                if (std::isfinite(static_cast<float>(lane))) continue;
                report_at(point.source,
                          point.name + ": '" + key.name() + "' holds " + shortest(lane) +
                              ", which single precision does not",
                          "--precision double does", diagnostics);
                fine = false;
            }
        }
    return fine;
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
    if (precision == Precision::single && !within_float(points, program, diagnostics)) return {};
    const PointSet set = point_set(points, program);
    const std::vector<Texture> images = textures.textures_of(run.compiled.module.resources);
    Results results = make_results(program, points.size());
    if (precision == Precision::single)
        evaluate<float>(program, set, images, 0, points.size(), results);
    else
        evaluate<double>(program, set, images, 0, points.size(), results);
    std::vector<OutputColumn> columns;
    for (size_t i = 0; i < program.outputs.size(); ++i) {
        const Program::Output& output = program.outputs[i];
        columns.push_back(
            {output.name, output.port_type, output.regs.size(), std::move(results.values[i])});
    }
    return columns;
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
