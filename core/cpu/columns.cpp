#include "cpu/columns.h"

#include <cmath>

#include "base/text.h"
#include "ir/op.h"

namespace wrinkle {
namespace {

constexpr std::array<std::string_view, 3> variant_prefixes = {"", "dx.", "dy."};

}  // namespace

std::string name_of(const InputNeed& need) {
    return std::string(variant_prefixes[static_cast<size_t>(need.variant)]) +
           std::string(info(need.input).name);
}

std::optional<InputNeed> find_input(std::string_view name) {
    Variant variant = Variant::value;
    for (const Variant each : {Variant::dx, Variant::dy})
        if (name.starts_with(variant_prefixes[static_cast<size_t>(each)])) variant = each;
    name.remove_prefix(variant_prefixes[static_cast<size_t>(variant)].size());
    for (int i = 0; i < surface_input_count; ++i)
        if (info(static_cast<SurfaceInput>(i)).name == name)
            return InputNeed{static_cast<SurfaceInput>(i), variant};
    return {};
}

std::vector<std::string> surface_input_names() {
    std::vector<std::string> names;
    for (int i = 0; i < surface_input_count; ++i)
        names.emplace_back(info(static_cast<SurfaceInput>(i)).name);
    return names;
}

size_t lanes_of(const InputNeed& need) {
    return info(info(need.input).type).lanes;
}

std::vector<OutputColumn> evaluate_columns(const Program& program, const PointSet& points,
                                           std::span<const Texture> textures, Precision precision) {
    Results results = make_results(program, points.count);
    if (precision == Precision::single)
        evaluate<float>(program, points, textures, 0, points.count, results);
    else
        evaluate<double>(program, points, textures, 0, points.count, results);
    std::vector<OutputColumn> columns;
    for (size_t i = 0; i < program.outputs.size(); ++i) {
        const Program::Output& output = program.outputs[i];
        columns.push_back(
            {output.name, output.port_type, output.regs.size(), std::move(results.values[i])});
    }
    return columns;
}

std::string FloatOverflow::message() const {
    return "'" + name_of(input) + "' holds " + shortest(value) +
           ", which single precision does not";
}

std::vector<FloatOverflow> float_overflow(const Program& program, const PointSet& points) {
    std::vector<FloatOverflow> found;
    for (const InputNeed& need : needed_inputs(program)) {
        const std::vector<double>& values = points.at(need.input, need.variant);
        for (size_t i = 0; i < values.size(); ++i)
            if (!std::isfinite(static_cast<float>(values[i])))
                found.push_back({i / lanes_of(need), need, values[i]});
    }
    return found;
}

}  // namespace wrinkle
