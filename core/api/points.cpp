#include <algorithm>
#include <cmath>

#include "api/parts.h"
#include "base/text.h"

namespace wrinkle::api {
namespace {

using Values = std::vector<double>;

std::string at_point(size_t point, const std::string& message) {
    return "point " + std::to_string(point) + ": " + message;
}

// Reports a wrong length, the first non-finite number and the first zero normal.
void check_values(const InputNeed& input, const Values& values, size_t count,
                  Diagnostics& diagnostics) {
    const size_t lanes = lanes_of(input);
    if (values.size() / lanes != count || values.size() % lanes != 0)
        return diagnostics.error(
            RuleId::point,
            "'" + name_of(input) + "' holds " + std::to_string(values.size()) + " numbers",
            std::to_string(lanes) + " for each of " + std::to_string(count) + " points");
    const auto bad = std::find_if(values.begin(), values.end(),
                                  [](double value) { return !std::isfinite(value); });
    if (bad != values.end())
        diagnostics.error(RuleId::point, at_point(static_cast<size_t>(bad - values.begin()) / lanes,
                                                  "'" + name_of(input) + "' is not finite"));
    if (input.input != SurfaceInput::normal_ || input.variant != Variant::value) return;
    for (size_t i = 0; i < count; ++i)
        if (values[i * 3] == 0 && values[i * 3 + 1] == 0 && values[i * 3 + 2] == 0)
            return diagnostics.error(RuleId::point, at_point(i, "normal is zero"),
                                     "a direction of any length but zero");
}

// Returns all valid names, for suggestions.
std::vector<std::string> point_names() {
    std::vector<std::string> names;
    for (const std::string& name : surface_input_names())
        for (const char* prefix : {"", "dx.", "dy."})
            names.push_back(prefix + name);
    return names;
}

}  // namespace

PointSet point_set(const Points& points, const Program& program, bool single,
                   Diagnostics& diagnostics) {
    PointSet set;
    set.count = points.count;
    for (const auto& [name, values] : points.values) {
        const auto input = find_input(name);
        if (!input)
            diagnostics.error(RuleId::point, "there is no '" + name + "'",
                              did_you_mean(name, point_names()));
        else
            check_values(*input, values, points.count, diagnostics);
    }
    if (diagnostics.has_errors()) return set;
    for (const InputNeed& need : needed_inputs(program)) {
        const auto found = points.values.find(name_of(need));
        if (found != points.values.end())
            set.at(need.input, need.variant) = found->second;
        else if (need.input == SurfaceInput::facing_)
            set.at(need.input, need.variant).assign(points.count, 1);
        else
            diagnostics.error(RuleId::point, "the points lack '" + name_of(need) + "'",
                              "the graph needs it");
    }
    if (single && !diagnostics.has_errors())
        for (const FloatOverflow& each : float_overflow(program, set))
            diagnostics.error(RuleId::precision_loss, at_point(each.point, each.message()),
                              "double precision does");
    return set;
}

}  // namespace wrinkle::api
