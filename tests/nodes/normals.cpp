#include "nodes/normals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "nodes/plane.h"

namespace wrinkle::test {
namespace {

Normal cross(const Normal& a, const Normal& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Normal& a, const Normal& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Height at (x, y) of the plane through the origin with normal n.
double height_at(const Normal& n, double x, double y) {
    return -(n[0] * x + n[1] * y) / n[2];
}

std::string from(const std::string& source) {
    return R"({"from": ")" + source + R"("})";
}
std::string blend(const std::string& id, const std::string& type, const std::string& base,
                  const std::string& detail, const std::string& in = "") {
    return "\"" + id + R"(": {"type": ")" + type + R"(", "in": {"base": )" + from(base) +
           R"(, "detail": )" + from(detail) + (in.empty() ? "" : ", ") + in + "}}";
}

const char* const third =
    R"("split": {"type": "separate_vec4", "in": {"vector": {"from": "surface.color0"}}},
       "third": {"type": "combine_vec3", "in": {"x": {"from": "split.x"},
                 "y": {"from": "split.y"}, "z": {"from": "split.z"}}})";

}  // namespace

Normal tilted(double tilt, double azimuth) {
    const double t = tilt * std::numbers::pi / 180, a = azimuth * std::numbers::pi / 180;
    return {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)};
}

double angle_between(const Normal& a, const Normal& b) {
    const Normal c = cross(a, b);
    return std::atan2(std::sqrt(dot(c, c)), dot(a, b)) * 180 / std::numbers::pi;
}

Normal of_added_heights(const Normal& a, const Normal& b) {
    const Normal along_x{1, 0, height_at(a, 1, 0) + height_at(b, 1, 0)};
    const Normal along_y{0, 1, height_at(a, 0, 1) + height_at(b, 0, 1)};
    return cross(along_x, along_y);
}

std::vector<Normal> read(const std::string& nodes, const std::string& output,
                         const std::vector<Pair>& pairs) {
    const Scene scene{nodes + (nodes.empty() ? "" : ", ") + third, output};
    PointSet points = plane_points(scene, std::vector<std::array<double, 2>>(pairs.size()));
    for (size_t i = 0; i < pairs.size(); ++i)
        for (size_t lane = 0; lane < 3; ++lane) {
            points.at(SurfaceInput::position_)[3 * i + lane] = pairs[i].base[lane];
            points.at(SurfaceInput::view_)[3 * i + lane] = pairs[i].detail[lane];
            points.at(SurfaceInput::color0_)[4 * i + lane] = pairs[i].other[lane];
        }
    std::vector<Normal> normals;
    for (const auto& lanes : values(scene, points))
        normals.push_back({lanes.at(0), lanes.at(1), lanes.at(2)});
    return normals;
}

std::vector<Normal> blended(const std::string& type, const std::string& in,
                            const std::vector<Pair>& pairs) {
    return read(blend("n", type, "surface.position", "surface.view", in), "n.normal", pairs);
}
std::vector<Normal> blended_left(const std::string& type, const std::vector<Pair>& pairs) {
    return read(blend("n", type, "surface.position", "surface.view") + ", " +
                    blend("m", type, "n.normal", "third.vector"),
                "m.normal", pairs);
}
std::vector<Normal> blended_right(const std::string& type, const std::vector<Pair>& pairs) {
    return read(blend("n", type, "surface.view", "third.vector") + ", " +
                    blend("m", type, "surface.position", "n.normal"),
                "m.normal", pairs);
}

std::vector<Pair> random_pairs(size_t count, double tilt) {
    std::mt19937 random(5);
    const auto draw = [&](double high) {
        return high * static_cast<double>(random()) / 4294967296.0;
    };
    std::vector<Pair> pairs(count);
    for (Pair& pair : pairs)
        for (Normal* normal : {&pair.base, &pair.detail, &pair.other}) {
            const double steepness = draw(tilt);
            *normal = tilted(steepness, draw(360));
        }
    return pairs;
}

std::vector<Pair> swapped(std::vector<Pair> pairs) {
    for (Pair& pair : pairs)
        std::swap(pair.base, pair.detail);
    return pairs;
}

Angles angles(const std::vector<Normal>& a, const std::vector<Normal>& b) {
    Angles result;
    for (size_t i = 0; i < a.size(); ++i) {
        const double angle = angle_between(a[i], b.at(i));
        result.mean += angle / static_cast<double>(a.size());
        result.max = std::max(result.max, angle);
    }
    return result;
}

std::vector<Normal> sums(const std::vector<Pair>& pairs) {
    std::vector<Normal> normals;
    for (const Pair& pair : pairs)
        normals.push_back(of_added_heights(pair.base, pair.detail));
    return normals;
}

}  // namespace wrinkle::test
