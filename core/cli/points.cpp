#include "cli/points.h"

#include <algorithm>

#include "base/file.h"
#include "base/text.h"
#include "cli/session.h"
#include "graph/document.h"
#include "ir/op.h"
#include "json/parse.h"

namespace wrinkle::cli {
namespace {

// Reads one point and reports problems at their values.
class PointReader {
public:
    PointReader(Point& point, Diagnostics& diagnostics)
        : point_(point), diagnostics_(diagnostics) {}

    void read(const json::Value& value) {
        if (!value.is(json::Kind::object))
            return error(value, "is " + std::string(json::kind_name(value.kind())),
                         "a point is an object such as {\"uv0\": [0.5, 0.5]}");
        for (const json::Member& member : value.children()) {
            if (member.key == "dx")
                read_group(member.value, Variant::dx, "dx");
            else if (member.key == "dy")
                read_group(member.value, Variant::dy, "dy");
            else
                read_slot(member, Variant::value);
        }
    }

private:
    void read_group(const json::Value& value, Variant variant, const std::string& name) {
        if (!value.is(json::Kind::object))
            return error(value, name + " is " + json::kind_name(value.kind()),
                         name + " is an object such as {\"uv0\": [0.001, 0]}");
        for (const json::Member& member : value.children())
            read_slot(member, variant);
    }

    void read_slot(const json::Member& member, Variant variant) {
        const auto input = find_input(member.key);
        if (!input || input->variant != Variant::value) {
            std::vector<std::string> names = surface_input_names();
            if (variant == Variant::value) names.insert(names.end(), {"dx", "dy"});
            return error(member.value, "there is no '" + std::string(member.key) + "'",
                         did_you_mean(member.key, names,
                                      "position, normal, tangent, uv0 ... uv3, color0, view, "
                                      "facing, dx, dy"));
        }
        const InputNeed key{input->input, variant};
        if (key.input == SurfaceInput::facing_ && variant != Variant::value)
            return error(member.value, name_of(key) + " has no meaning", "facing does not change");
        point_[key].given = read_lanes(key, member.value, point_[key].lanes);
        if (key.input == SurfaceInput::normal_ && variant == Variant::value && point_[key].given &&
            is_zero(point_[key]))
            error(member.value, "normal is zero", "a direction of any length but zero");
    }

    static bool is_zero(const Point::Slot& slot) {
        return std::all_of(slot.lanes.begin(), slot.lanes.end(), [](double x) { return x == 0; });
    }

    bool read_lanes(const InputNeed& key, const json::Value& value, std::array<double, 4>& lanes) {
        const size_t count = lanes_of(key);
        const bool fits = count == 1 ? value.is(json::Kind::number)
                                     : value.is(json::Kind::array) && value.size() == count;
        bool fine = fits;
        size_t lane = 0;
        if (fits && count == 1) lanes[0] = value.as_number();
        if (fits && count > 1)
            for (const json::Member& member : value.children()) {
                fine = fine && member.value.is(json::Kind::number);
                if (fine) lanes[lane++] = member.value.as_number();
            }
        if (!fine)
            error(value, name_of(key) + " does not fit",
                  count == 1 ? "a number" : "an array of " + std::to_string(count) + " numbers");
        return fine;
    }

    void error(const json::Value& value, const std::string& message, const std::string& expected) {
        report_at(value, point_.name + ": " + message, expected, diagnostics_);
    }

    Point& point_;
    Diagnostics& diagnostics_;
};

Point read_point(const json::Value& value, size_t number, Diagnostics& diagnostics) {
    Point point;
    point.name = "point " + std::to_string(number);
    point.source = value;
    point[{SurfaceInput::facing_}] = {true, {1}};
    PointReader(point, diagnostics).read(value);
    return point;
}

}  // namespace

std::vector<Point> read_points(const json::Value& value, Diagnostics& diagnostics) {
    std::vector<Point> points;
    if (!value.is(json::Kind::array)) {
        points.push_back(read_point(value, 0, diagnostics));
        return points;
    }
    for (const json::Member& member : value.children())
        points.push_back(read_point(member.value, points.size(), diagnostics));
    return points;
}

std::vector<Point> points_of_option(const std::string& at, Diagnostics& diagnostics) {
    std::optional<std::string> text = at;
    std::string name = "--at";
    if (at == "-" || at.starts_with('@')) {
        const std::string file = at == "-" ? at : at.substr(1);
        name = stream_title(file).empty() ? file : stream_title(file);
        text = read_text(file, diagnostics);
    }
    if (!text) return {};
    Diagnostics own;
    const json::Parsed parsed = json::parse(*text, name, own);
    diagnostics.append(own);
    if (own.has_errors()) return {};
    return read_points(parsed.root, diagnostics);
}

}  // namespace wrinkle::cli
