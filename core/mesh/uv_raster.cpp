#include "mesh/uv_raster.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <tuple>

#include "mesh/uv_raster_parts.h"
#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

constexpr double max_distance = 1LL << 29;  // products of differences then fit into 64 bits

// Returns the last texel of a row with its centre inside a rising edge, or minus the first such
// texel for a falling edge: floor(edge value at the row's first texel / change per texel).
int64_t edge_texel(const RasterEdge& edge, int64_t row) {
    const int64_t y = row * units + units / 2;
    const int64_t at_zero =
        edge.dx * (y - edge.ay) - edge.dy * (units / 2 - edge.ax) - edge.min_inside();
    return floor_div(at_zero, std::abs(edge.dy) * units);
}

// Returns the rows of [first, first + count) with centres between the lowest and the highest corner
// of the triangle, excluding centres on a horizontal top edge.
template <class Triangle>
TexelRange centres_within(const Triangle& t, uint32_t first, uint32_t count) {
    const auto [low, high] = std::minmax({t.y[0], t.y[1], t.y[2]});
    int64_t below = int64_t{high} - units / 2;
    for (size_t k = 0; k < 3; ++k)
        if (t.y[k] == high && t.y[(k + 1) % 3] == high) --below;
    return {std::max<int64_t>(texel_at(int64_t{low} + units / 2 - 1), first),
            std::min<int64_t>(texel_at(below), int64_t{first} + count - 1)};
}

TexelRange texels_of(const int32_t (&corners)[3]) {
    const auto [low, high] = std::minmax({corners[0], corners[1], corners[2]});
    return {texel_at(low), texel_at(high)};
}

// An edge by its ends, the lower one first, so that both of its sides have the same key.
struct UvEdge {
    int32_t low_x, low_y, high_x, high_y;
    uint32_t triangle;
    uint8_t k;
    bool turned;

    auto key() const { return std::tie(low_x, low_y, high_x, high_y); }
};

template <class Triangle>
UvEdge uv_edge(const Triangle& t, uint32_t index, uint8_t k) {
    const size_t a = k, b = (k + 1U) % 3;
    const bool turned = std::pair(t.x[b], t.y[b]) < std::pair(t.x[a], t.y[a]);
    const size_t low = turned ? b : a, high = turned ? a : b;
    return {t.x[low], t.y[low], t.x[high], t.y[high], index, k, turned};
}

}  // namespace

UvRaster::UvRaster(const Mesh& mesh, const UvLayout& layout)
    : layout_(layout),
      across_(static_cast<uint32_t>(std::lround(std::sqrt(static_cast<double>(layout.samples))))) {
    assert(mesh.has_uv(0) && across_ * across_ == layout.samples && across_ <= 8);
    triangles_.resize(mesh.triangle_count());
    rows_.resize(mesh.triangle_count());
    for (size_t i = 0; i < mesh.triangle_count(); ++i)
        add(mesh, i);
    drop_repeats();
    if (across_ > 1) find_borders();
}

void UvRaster::add(const Mesh& mesh, size_t index) {
    Triangle t;
    if (!has_uv_area(mesh, index)) return;
    for (size_t k = 0; k < 3; ++k) {
        const glm::dvec2 uv(mesh.uvs[0][mesh.indices[3 * index + k]]);
        const double x = (uv.x - layout_.corner.x) * layout_.width * units;
        const double y = (uv.y - layout_.corner.y) * layout_.height * units;
        if (!(std::fabs(x) < max_distance) || !(std::fabs(y) < max_distance)) return;
        t.x[k] = static_cast<int32_t>(std::lrint(x));
        t.y[k] = static_cast<int32_t>(std::lrint(y));
    }
    const RasterEdge edge = edge_of(t, 0);
    const int64_t area = edge.dx * (t.y[2] - edge.ay) - edge.dy * (t.x[2] - edge.ax);
    if (area == 0) return;
    if (area < 0) {
        std::swap(t.x[1], t.x[2]);
        std::swap(t.y[1], t.y[2]);
    }
    t.columns = texels_of(t.x);
    triangles_[index] = t;
    rows_[index] = texels_of(t.y);
}

// Runs only if the triangles' boxes cover the layout more than 16 times.
void UvRaster::drop_repeats() {
    constexpr int64_t many = 16;
    const int64_t all = int64_t{layout_.width} * layout_.height;
    int64_t held = 0;
    for (size_t i = 0; i < triangles_.size() && held <= many * all; ++i) {
        const TexelRange columns = triangles_[i].columns.within(0, layout_.width);
        const TexelRange rows = rows_[i].within(0, layout_.height);
        if (!columns.empty() && !rows.empty())
            held += (columns.high - columns.low + 1) * (rows.high - rows.low + 1);
    }
    if (held <= many * all) return;
    each_third_repeat(triangles_, [&](uint32_t index) {
        triangles_[index].columns = {};
        rows_[index] = {};
    });
}

void UvRaster::find_borders() {
    std::vector<UvEdge> edges;
    edges.reserve(3 * triangles_.size());
    for (uint32_t i = 0; i < triangles_.size(); ++i)
        for (uint8_t k = 0; k < 3; ++k)
            if (rows_[i].low <= rows_[i].high) edges.push_back(uv_edge(triangles_[i], i, k));
    std::ranges::sort(edges, {}, &UvEdge::key);
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::find_if(
            first, edges.end(), [&](const UvEdge& edge) { return edge.key() != first->key(); });
        const auto turned = std::count_if(first, last, [](const UvEdge& e) { return e.turned; });
        const bool border = turned == 0 || turned == last - first;
        for (; first != last; ++first)
            if (border) triangles_[first->triangle].borders |= static_cast<uint8_t>(1U << first->k);
    }
}

std::vector<RowCandidate> UvRaster::in_rows(uint32_t y, uint32_t height) const {
    std::vector<RowCandidate> found;
    for (uint32_t i = 0; i < triangles_.size(); ++i) {
        const TexelRange& columns = triangles_[i].columns;
        if (!rows_[i].within(y, height).empty() && !columns.within(0, layout_.width).empty())
            found.push_back({i, columns});
    }
    return found;
}

void UvRaster::cover(const TexelRect& rect, std::span<const RowCandidate> candidates,
                     Coverage& out) const {
    out.edges.clear();
    out.samples.clear();
    out.candidates.clear();
    for (const auto& [triangle, columns] : candidates)
        if (!columns.within(rect.x, rect.width).empty()) out.candidates.push_back(triangle);
    own_centres(rect, out);
    if (across_ == 1) return;
    out.slots.assign(out.owners.size(), Coverage::none);
    for (const uint32_t index : out.candidates)
        if (triangles_[index].borders) mark_borders(rect, index, out);
    uint32_t count = 0;
    for (uint32_t& slot : out.slots)
        if (slot == marked) slot = count++;
    if (count == 0) return;
    out.sub_owners.assign(size_t{count} * layout_.samples, Coverage::none);
    for (const uint32_t index : out.candidates)
        own_samples(rect, index, out);
    gather_edges(rect, out);
}

template <class Take>
void UvRaster::each_span(const TexelRect& rect, uint32_t index, Take take) const {
    const Triangle& t = triangles_[index];
    const TexelRange columns = t.columns.within(rect.x, rect.width);
    const TexelRange rows = centres_within(t, rect.y, rect.height);
    const RasterEdge edges[] = {edge_of(t, 0), edge_of(t, 1), edge_of(t, 2)};
    for (int64_t y = rows.low; y <= rows.high; ++y) {
        TexelRange span = columns;
        for (const RasterEdge& edge : edges) {
            if (edge.dy < 0) span.low = std::max(span.low, -edge_texel(edge, y));
            if (edge.dy > 0) span.high = std::min(span.high, edge_texel(edge, y));
        }
        const int64_t row_start = (y - rect.y) * rect.width - rect.x;
        if (!span.empty())
            take(static_cast<size_t>(row_start + span.low),
                 static_cast<size_t>(row_start + span.high));
    }
}

// The first triangle in the mesh owns a texel; the second one reveals an overlap.
void UvRaster::own_centres(const TexelRect& rect, Coverage& out) const {
    out.owners.assign(size_t{rect.width} * rect.height, Coverage::none);
    out.owned = out.overlapped = 0;
    out.overlap_triangle = Coverage::none;
    out.open.open_all(out.owners.size());
    const auto take = [&out](uint32_t index, size_t texel) {
        uint32_t& owner = out.owners[texel];
        if (owner == Coverage::none) {
            owner = index;
            ++out.owned;
            return;
        }
        out.open.close(texel);
        if (out.overlapped++ == 0 || texel < out.overlap_texel) {
            out.overlap_texel = static_cast<uint32_t>(texel);
            out.overlap_triangle = index;
        }
    };
    for (const uint32_t index : out.candidates)
        each_span(rect, index, [&](size_t first, size_t last) {
            for (size_t texel = out.open.first_open(first); texel <= last;
                 texel = out.open.first_open(texel + 1))
                take(index, texel);
        });
}

}  // namespace wrinkle
