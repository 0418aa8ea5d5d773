#include "mesh/vertex_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <span>
#include <tuple>

#include "mesh/weld.h"

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr uint32_t absent = UINT32_MAX;
constexpr double min_area = 1.17549435e-38;  // smallest normal float, as in the reference

dvec3 in_plane(dvec3 v, dvec3 normal) {
    return unit_or_zero(v - glm::dot(normal, v) * normal);
}

struct Triangle {
    std::array<uint32_t, 3> vertices;                        // welded corners
    std::array<uint32_t, 3> across{absent, absent, absent};  // across the edge from corner k
    std::array<uint32_t, 3> groups{absent, absent, absent};
    dvec3 along_u{0};       // unit, or zero
    float sign = -1;        // sign of the uv area
    bool joins = true;      // no area in uv: joins a group of either sign
    bool is_point = false;  // two corners at the same position
};

// The corners at one welded vertex that share a tangent.
struct Group {
    uint32_t vertex;
    float sign;
    std::vector<uint32_t> triangles;
};

size_t corner_at(const Triangle& triangle, uint32_t vertex) {
    const auto* found = std::ranges::find(triangle.vertices, vertex);
    return static_cast<size_t>(found - triangle.vertices.begin());
}

class TangentMaker {
public:
    explicit TangentMaker(Mesh& mesh) : mesh_(mesh), welded_(weld_frames(mesh)) {}

    void run() {
        read_triangles();
        link_neighbours();
        make_groups();
        std::vector<glm::vec4> corners(mesh_.indices.size(), glm::vec4(0));
        for (const Group& group : groups_)
            average(group, corners);
        lend_to_points(corners);
        assign(corners);
    }

private:
    void read_triangles() {
        triangles_.resize(mesh_.triangle_count());
        for (size_t t = 0; t < triangles_.size(); ++t) {
            Triangle& triangle = triangles_[t];
            for (size_t k = 0; k < 3; ++k)
                triangle.vertices[k] = welded_[mesh_.indices[3 * t + k]];
            const dvec3 p[3] = {position(triangle, 0), position(triangle, 1),
                                position(triangle, 2)};
            triangle.is_point = p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
            orient(triangle, p[1] - p[0], p[2] - p[0]);
        }
    }

    dvec3 position(const Triangle& triangle, size_t corner) const {
        return mesh_.positions[triangle.vertices[corner]];
    }

    void orient(Triangle& triangle, dvec3 p1, dvec3 p2) const {
        const auto uv = [&](size_t k) { return dvec2(mesh_.uvs[0][triangle.vertices[k]]); };
        const dvec2 d1 = uv(1) - uv(0);
        const dvec2 d2 = uv(2) - uv(0);
        const double area = d1.x * d2.y - d2.x * d1.y;
        if (area > 0) triangle.sign = 1;
        if (!(std::abs(area) > min_area) || !std::isfinite(area)) return;
        const double sign = triangle.sign;
        triangle.along_u = unit_or_zero(sign * (d2.y * p1 - d1.y * p2));
        const dvec3 along_v = unit_or_zero(sign * (d1.x * p2 - d2.x * p1));
        triangle.joins = triangle.along_u == dvec3(0) || along_v == dvec3(0);
    }

    // Each triangle has at most one neighbour per edge, even if more than two triangles share it.
    void link_neighbours() {
        using Edge = std::tuple<uint32_t, uint32_t, uint32_t, uint32_t>;  // low, high, triangle, k
        std::vector<Edge> edges;
        for (uint32_t t = 0; t < triangles_.size(); ++t)
            for (uint32_t k = 0; k < 3 && !triangles_[t].is_point; ++k)
                edges.emplace_back(std::min(start(t, k), start(t, k + 1)),
                                   std::max(start(t, k), start(t, k + 1)), t, k);
        std::ranges::sort(edges);
        for (size_t first = 0; first < edges.size();) {
            size_t last = first;
            while (last < edges.size() && std::get<0>(edges[last]) == std::get<0>(edges[first]) &&
                   std::get<1>(edges[last]) == std::get<1>(edges[first]))
                ++last;
            pair_up(std::span(edges).subspan(first, last - first));
            first = last;
        }
    }

    uint32_t start(uint32_t triangle, uint32_t k) const {
        return triangles_[triangle].vertices[k % 3];
    }

    // Links the i-th triangle that runs upwards along the edge to the i-th that runs downwards.
    template <typename Edges>
    void pair_up(Edges edges) {
        const auto is_up = [&](const auto& e) {
            return start(std::get<2>(e), std::get<3>(e)) == std::get<0>(e);
        };
        auto up = edges.begin(), down = edges.begin();
        while (true) {
            up = std::find_if(up, edges.end(), is_up);
            down = std::find_if_not(down, edges.end(), is_up);
            if (up == edges.end() || down == edges.end()) return;
            triangles_[std::get<2>(*up)].across[std::get<3>(*up)] = std::get<2>(*down);
            triangles_[std::get<2>(*down)].across[std::get<3>(*down)] = std::get<2>(*up);
            ++up, ++down;
        }
    }

    void make_groups() {
        for (uint32_t t = 0; t < triangles_.size(); ++t)
            for (size_t k = 0; k < 3; ++k) {
                const Triangle& triangle = triangles_[t];
                if (triangle.is_point || triangle.joins || triangle.groups[k] != absent) continue;
                groups_.push_back({triangle.vertices[k], triangle.sign, {}});
                grow(t);
            }
    }

    // Flood fill from `seed` across the two edges at the welded vertex, over triangles of one sign.
    void grow(uint32_t seed) {
        const auto number = static_cast<uint32_t>(groups_.size() - 1);
        Group& group = groups_.back();
        std::vector<uint32_t> open{seed};
        while (!open.empty()) {
            const uint32_t t = open.back();
            open.pop_back();
            if (t == absent) continue;
            Triangle& triangle = triangles_[t];
            const size_t k = corner_at(triangle, group.vertex);
            if (k == 3 || triangle.groups[k] != absent) continue;
            const bool is_free = triangle.groups == std::array{absent, absent, absent};
            if (triangle.joins && is_free) triangle.sign = group.sign;
            if (triangle.sign != group.sign) continue;
            triangle.groups[k] = number;
            group.triangles.push_back(t);
            open.insert(open.end(), {triangle.across[k], triangle.across[(k + 2) % 3]});
        }
    }

    void average(const Group& group, std::vector<glm::vec4>& corners) const {
        const dvec3 normal = unit_or_zero(mesh_.normals[group.vertex]);
        dvec3 sum(0);
        for (const uint32_t t : group.triangles) {
            const Triangle& triangle = triangles_[t];
            if (triangle.joins) continue;
            const size_t k = corner_at(triangle, group.vertex);
            const dvec3 at = position(triangle, k);
            const dvec3 a = in_plane(position(triangle, (k + 2) % 3) - at, normal);
            const dvec3 b = in_plane(position(triangle, (k + 1) % 3) - at, normal);
            const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
            sum += angle * in_plane(triangle.along_u, normal);
        }
        // Below this length the contributions cancel and only rounding errors remain.
        const dvec3 mean = glm::length(sum) > 1e-12 ? in_plane(sum, normal) : dvec3(0);
        for (const uint32_t t : group.triangles) {
            dvec3 direction = mean;
            if (direction == dvec3(0)) direction = in_plane(triangles_[t].along_u, normal);
            const glm::vec3 tangent =
                direction == dvec3(0) ? any_perpendicular(normal) : glm::vec3(direction);
            corners[3 * t + corner_at(triangles_[t], group.vertex)] = {tangent, group.sign};
        }
    }

    // Triangles with two equal corners take the first tangent at the welded vertex.
    void lend_to_points(std::vector<glm::vec4>& corners) const {
        std::vector<uint32_t> lender(mesh_.vertex_count(), absent);
        for (uint32_t i = 0; i < corners.size(); ++i) {
            uint32_t& first = lender[triangles_[i / 3].vertices[i % 3]];
            if (first == absent && corners[i] != glm::vec4(0)) first = i;
        }
        for (uint32_t i = 0; i < corners.size(); ++i) {
            const uint32_t vertex = triangles_[i / 3].vertices[i % 3];
            if (corners[i] != glm::vec4(0)) continue;
            if (triangles_[i / 3].is_point && lender[vertex] != absent)
                corners[i] = corners[lender[vertex]];
            else
                corners[i] = glm::vec4(any_perpendicular(mesh_.normals[vertex]), 1);
        }
    }

    // A vertex keeps the tangent of its first corner; each other tangent creates a copy of the
    // vertex.
    void assign(const std::vector<glm::vec4>& corners) {
        const size_t count = mesh_.vertex_count();
        std::vector<glm::vec4> tangents(count, glm::vec4(0));
        std::map<std::tuple<uint32_t, float, float, float, float>, uint32_t> copies;
        std::vector<uint32_t> sources;
        for (size_t i = 0; i < corners.size(); ++i) {
            const uint32_t vertex = mesh_.indices[i];
            const glm::vec4 t = corners[i];
            if (tangents[vertex] == glm::vec4(0)) tangents[vertex] = t;
            if (tangents[vertex] == t) continue;
            const auto next = static_cast<uint32_t>(count + sources.size());
            const auto [at, is_new] = copies.try_emplace({vertex, t.x, t.y, t.z, t.w}, next);
            if (is_new) {
                sources.push_back(vertex);
                tangents.push_back(t);
            }
            mesh_.indices[i] = at->second;
        }
        for (size_t v = 0; v < count; ++v)
            if (tangents[v] == glm::vec4(0))
                tangents[v] = glm::vec4(any_perpendicular(mesh_.normals[v]), 1);
        mesh_.tangents.clear();
        each_vertex_array(mesh_, [&](auto& values) {
            for (size_t i = 0; i < sources.size() && !values.empty(); ++i)
                values.push_back(values[sources[i]]);
        });
        mesh_.tangents = std::move(tangents);
    }

    Mesh& mesh_;
    std::vector<uint32_t> welded_;
    std::vector<Triangle> triangles_;
    std::vector<Group> groups_;
};

}  // namespace

glm::vec3 any_perpendicular(dvec3 normal) {
    const dvec3 unit = unit_or_zero(normal);
    const dvec3 axis = std::abs(unit.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 result = in_plane(axis, unit);
    return result == dvec3(0) ? glm::vec3(1, 0, 0) : glm::vec3(result);
}

bool make_tangents(Mesh& mesh) {
    if (!mesh.has_uv(0) || mesh.normals.empty()) return false;
    TangentMaker(mesh).run();
    return true;
}

void ensure_tangents(Mesh& mesh) {
    if (mesh.tangents.empty()) make_tangents(mesh);
}

}  // namespace wrinkle
