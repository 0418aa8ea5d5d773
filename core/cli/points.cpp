#include "cli/points.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "cli/meshes.h"
#include "graph/document.h"
#include "json/parse.h"
#include "mesh/sample.h"

namespace wrinkle::cli {
namespace {

// Reads one point; problems are reported at the values they concern.
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

std::optional<glm::dvec2> parse_uv(const std::string& text) {
    const auto parts = split(text, ',');
    glm::dvec2 uv(0);
    if (parts.size() != 2) return {};
    for (int i = 0; i < 2; ++i) {
        const std::string_view part = parts[static_cast<size_t>(i)];
        const auto [end, problem] = std::from_chars(part.data(), part.data() + part.size(), uv[i]);
        if (problem != std::errc{} || end != part.data() + part.size() || !std::isfinite(uv[i]))
            return {};
    }
    return uv;
}

template <typename Vector>
Point::Slot slot_of(const Vector& vector) {
    Point::Slot slot{true, {}};
    for (int i = 0; i < Vector::length(); ++i)
        slot.lanes[static_cast<size_t>(i)] = vector[i];
    return slot;
}

void set_attributes(Point& point, Variant variant, const SurfaceAttributes& value,
                    const AttributePresence& has) {
    point[{SurfaceInput::position_, variant}] = slot_of(value.position);
    if (has.normal) point[{SurfaceInput::normal_, variant}] = slot_of(value.normal);
    if (has.tangent) point[{SurfaceInput::tangent_, variant}] = slot_of(value.tangent);
    if (has.color) point[{SurfaceInput::color0_, variant}] = slot_of(value.color);
    for (size_t set = 0; set < max_uv_sets; ++set) {
        const auto input = static_cast<SurfaceInput>(static_cast<size_t>(SurfaceInput::uv0_) + set);
        if (has.uv[set]) point[{input, variant}] = slot_of(value.uv[set]);
    }
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
        name = at == "-" ? "<stdin>" : at.substr(1);
        text = read_text(at == "-" ? at : name, diagnostics);
    }
    if (!text) return {};
    Diagnostics own;
    const json::Parsed parsed = json::parse(*text, name, own);
    diagnostics.append(own);
    if (own.has_errors()) return {};
    return read_points(parsed.root, diagnostics);
}

bool is_uv(const std::string& text) {
    return parse_uv(text).has_value();
}

std::vector<Point> points_on_mesh(const MeshPlace& place, const CommonOptions& options,
                                  Diagnostics& diagnostics) {
    const std::optional<Mesh> mesh = open_mesh(place.mesh, options, diagnostics);
    const auto uv = parse_uv(place.uv);
    if (!mesh || !uv) return {};
    const auto sampled = sample_mesh(*mesh, *uv, place.size, diagnostics);
    if (!sampled) return {};
    Point point;
    point.name = place.mesh + " at " + place.uv;
    point[{SurfaceInput::facing_}] = {true, {1}};
    set_attributes(point, Variant::value, sampled->value, sampled->has);
    set_attributes(point, Variant::dx, sampled->dx, sampled->has);
    set_attributes(point, Variant::dy, sampled->dy, sampled->has);
    return {point};
}

bool all_given(const std::vector<Point>& points, const Program& program, Diagnostics& diagnostics) {
    bool fine = true;
    const std::vector<InputNeed> needs = needed_inputs(program);
    for (const Point& point : points)
        for (const InputNeed& need : needs) {
            if (point[need].given) continue;
            report_at(point.source, point.name + " lacks '" + name_of(need) + "'",
                      "the graph needs it", diagnostics);
            fine = false;
        }
    return fine;
}

PointSet point_set(const std::vector<Point>& points, const Program& program) {
    PointSet set;
    set.count = points.size();
    for (const InputNeed& need : needed_inputs(program)) {
        const size_t count = lanes_of(need);
        std::vector<double>& values = set.at(need.input, need.variant);
        for (const Point& point : points) {
            const auto& lanes = point[need].lanes;
            values.insert(values.end(), lanes.begin(), lanes.begin() + static_cast<long>(count));
        }
    }
    return set;
}

}  // namespace wrinkle::cli
