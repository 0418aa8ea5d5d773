#include "cli/points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/file.h"
#include "base/text.h"
#include "cli/session.h"
#include "graph/document.h"
#include "ir/op.h"
#include "json/parse.h"

namespace wrinkle::cli {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

// Reads points and reports problems at their values.
class PointReader {
public:
    PointReader(PointList& list, Diagnostics& diagnostics)
        : list_(list), diagnostics_(diagnostics) {}

    void read(const json::Value& value) {
        list_.sources.push_back(value);
        list_.set({SurfaceInput::facing_}, list_.given.count++, 0, 1);
        if (!value.is(json::Kind::object))
            return error(value, "is " + std::string(json::kind_name(value.kind())),
                         "a point is an object such as {\"uv0\": [0.5, 0.5]}");
        for (const json::Member& member : value.children()) {
            if (member.key == "dx")
                read_changes(member.value, Variant::dx, "dx");
            else if (member.key == "dy")
                read_changes(member.value, Variant::dy, "dy");
            else
                read_input(member, Variant::value);
        }
    }

private:
    void read_changes(const json::Value& value, Variant variant, const std::string& name) {
        if (!value.is(json::Kind::object))
            return error(value, name + " is " + json::kind_name(value.kind()),
                         name + " is an object such as {\"uv0\": [0.001, 0]}");
        for (const json::Member& member : value.children())
            read_input(member, variant);
    }

    void read_input(const json::Member& member, Variant variant) {
        const auto input = find_input(member.key);
        if (!input || input->variant != Variant::value) {
            std::vector<std::string> names = surface_input_names();
            if (variant == Variant::value) names.insert(names.end(), {"dx", "dy"});
            return error(member.value, "there is no '" + std::string(member.key) + "'",
                         did_you_mean(member.key, names,
                                      "position, normal, tangent, uv0 ... uv3, color0, view, "
                                      "facing, dx, dy"));
        }
        const InputNeed need{input->input, variant};
        if (need.input == SurfaceInput::facing_ && variant != Variant::value)
            return error(member.value, name_of(need) + " has no meaning", "facing does not change");
        read_lanes(need, member);
    }

    void read_lanes(const InputNeed& need, const json::Member& member) {
        const size_t lanes = lanes_of(need);
        const bool has_form = lanes == 1 || member.value.is(json::Kind::array);
        std::vector<json::Member> numbers;
        if (lanes == 1) numbers.push_back(member);
        for (const json::Member& each : member.value.children())
            numbers.push_back(each);
        const auto is_number = [](const json::Member& each) {
            return each.value.is(json::Kind::number);
        };
        if (!has_form || numbers.size() != lanes || !std::ranges::all_of(numbers, is_number))
            return error(
                member.value, name_of(need) + " does not fit",
                lanes == 1 ? "a number" : "an array of " + std::to_string(lanes) + " numbers");
        bool is_zero = true;
        for (size_t lane = 0; lane < lanes; ++lane) {
            const double number = numbers[lane].value.as_number();
            list_.set(need, list_.given.count - 1, lane, number);
            is_zero = is_zero && number == 0;
        }
        if (need.input == SurfaceInput::normal_ && need.variant == Variant::value && is_zero)
            error(member.value, "normal is zero", "a direction of any length but zero");
    }

    void error(const json::Value& value, const std::string& message, const std::string& expected) {
        report_at(value, RuleId::point,
                  "point " + std::to_string(list_.given.count - 1) + ": " + message, expected,
                  diagnostics_);
    }

    PointList& list_;
    Diagnostics& diagnostics_;
};

}  // namespace

void PointList::set(const InputNeed& need, size_t point, size_t lane, double value) {
    std::vector<double>& column = given.at(need.input, need.variant);
    const size_t lanes = lanes_of(need);
    if (column.size() < (point + 1) * lanes) column.resize((point + 1) * lanes, missing);
    column[point * lanes + lane] = value;
}

void PointList::finish() {
    given.at(SurfaceInput::facing_).resize(given.count, 1);
    for (int i = 0; i < surface_input_count; ++i)
        for (const Variant variant : {Variant::value, Variant::dx, Variant::dy}) {
            const InputNeed need{static_cast<SurfaceInput>(i), variant};
            std::vector<double>& column = given.at(need.input, variant);
            if (!column.empty()) column.resize(given.count * lanes_of(need), missing);
        }
}

bool PointList::check(const Needs& needs, Diagnostics& diagnostics) const {
    const size_t errors = diagnostics.error_count();
    for (const InputNeed& need : needs)
        if (!file.empty() && count() > 0 && given.at(need.input, need.variant).empty())
            diagnostics.add(file_problem(
                Severity::error, RuleId::point, file, lacks("the table", need),
                "the graph needs it: " + column_name(name_of(need), 0, lanes_of(need))));
    for (size_t point = 0; point < sources.size(); ++point)
        for (const InputNeed& need : needs) {
            const std::vector<double>& column = given.at(need.input, need.variant);
            if (column.empty() || std::isnan(column[point * lanes_of(need)]))
                report_at(sources[point], RuleId::point,
                          lacks("point " + std::to_string(point), need), "the graph needs it",
                          diagnostics);
        }
    return diagnostics.error_count() == errors;
}

void PointList::report(size_t point, RuleId rule, Severity severity, std::string message,
                       std::string expected, Diagnostics& diagnostics) const {
    if (numbered) message = "point " + std::to_string(point) + ": " + message;
    if (!sources.empty())
        return report_at(sources[point], rule, std::move(message), std::move(expected), diagnostics,
                         severity);
    Diagnostic problem =
        file_problem(severity, rule, file, std::move(message), std::move(expected));
    if (first_line > 0) problem.where = {file, first_line + static_cast<uint32_t>(point), 1};
    diagnostics.add(std::move(problem));
}

std::string lacks(const std::string& owner, const InputNeed& need) {
    return owner + " lacks '" + name_of(need) + "'";
}

PointList read_points(const json::Value& value, Diagnostics& diagnostics) {
    PointList list;
    PointReader reader(list, diagnostics);
    if (!value.is(json::Kind::array)) reader.read(value);
    if (value.is(json::Kind::array))
        for (const json::Member& member : value.children())
            reader.read(member.value);
    list.finish();
    return list;
}

PointList open_list(const std::string& at, Diagnostics& diagnostics) {
    const bool is_table = at.ends_with(".csv") || at.ends_with(".npy");
    const bool is_text = !is_table && at != "-" && !at.starts_with('@');
    const std::string file = at.starts_with('@') ? at.substr(1) : at;
    const auto text = is_text ? at : read_text(file, diagnostics);
    if (!text) return {};
    if (is_table) return read_table(file, *text, diagnostics);
    const std::string stream = stream_title(file);
    Diagnostics own;
    const json::Parsed parsed = json::parse(*text,
                                            is_text          ? "--at"
                                            : stream.empty() ? file
                                                             : stream,
                                            own);
    diagnostics.append(own);
    return own.has_errors() ? PointList() : read_points(parsed.root, diagnostics);
}

}  // namespace wrinkle::cli
