#include "mesh/readers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numeric>

namespace wrinkle {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr size_t max_ears = 256;  // ear clipping is O(n^3)

// Twice the area vector: the sum of the cross products along the border (Newell).
dvec3 border_normal(std::span<const glm::vec3> positions) {
    const dvec3 origin = positions[0];
    dvec3 sum(0);
    for (size_t i = 0; i < positions.size(); ++i)
        sum += glm::cross(dvec3(positions[i]) - origin,
                          dvec3(positions[(i + 1) % positions.size()]) - origin);
    return sum;
}

// Projects along the coordinate axis nearest to the normal; the polygon keeps its orientation.
std::vector<dvec2> flattened(std::span<const glm::vec3> positions) {
    const dvec3 normal = border_normal(positions);
    const dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    std::vector<dvec2> result;
    for (const dvec3 p : positions) {
        const dvec2 q(p[(axis + 1) % 3], p[(axis + 2) % 3]);
        result.push_back(normal[axis] < 0 ? dvec2(q.y, q.x) : q);
    }
    return result;
}

double turn(dvec2 a, dvec2 b, dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Returns true if no corner turns right and the border winds around once at most.
bool is_convex(const std::vector<dvec2>& p) {
    const size_t n = p.size();
    for (size_t i = 0; i < n; ++i)
        if (turn(p[i], p[(i + 1) % n], p[(i + 2) % n]) < 0) return false;
    for (size_t i = 1; i + 1 < n; ++i)
        if (turn(p[0], p[i], p[i + 1]) < 0) return false;
    return true;
}

template <typename Emit>
void clip_ears(const std::vector<dvec2>& points, Emit emit) {
    std::vector<size_t> left(points.size());
    std::iota(left.begin(), left.end(), size_t{0});
    const auto before = [&](size_t i) { return left[(i + left.size() - 1) % left.size()]; };
    const auto after = [&](size_t i) { return left[(i + 1) % left.size()]; };
    const auto is_ear = [&](size_t i) {
        const dvec2 a = points[before(i)], b = points[left[i]], c = points[after(i)];
        if (!(turn(a, b, c) > 0)) return false;
        return std::ranges::none_of(left, [&](size_t other) {
            const dvec2 p = points[other];
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0;
        });
    };
    while (left.size() > 3) {
        size_t i = 1;
        while (i <= left.size() && !is_ear(i % left.size()))
            ++i;
        // No ear: the polygon crosses itself.
        const size_t ear = i <= left.size() ? i % left.size() : 1;
        emit(before(ear), left[ear], after(ear));
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    emit(left[0], left[1], left[2]);
}

}  // namespace

void append_triangles(std::span<const glm::vec3> positions, std::span<const uint32_t> corners,
                      std::vector<uint32_t>& indices) {
    const auto emit = [&](size_t a, size_t b, size_t c) {
        indices.insert(indices.end(), {corners[a], corners[b], corners[c]});
    };
    if (corners.size() > 3 && corners.size() <= max_ears) {
        const std::vector<dvec2> flat = flattened(positions);
        if (!is_convex(flat)) return clip_ears(flat, emit);
    }
    for (size_t i = 1; i + 1 < corners.size(); ++i)
        emit(0, i, i + 1);
}

}  // namespace wrinkle
