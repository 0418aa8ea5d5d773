#include "mesh/uv_raster.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <optional>
#include <tuple>

#include "mesh/uv_raster_parts.h"
#include "mesh/uv_triangle.h"

namespace wrinkle {
namespace {

constexpr double furthest = 1LL << 29;  // products of differences then fit into 64 bits

constexpr size_t group = 32;  // consecutive triangles per group

// For each row, upwards: the last texel with its centre inside a non-horizontal edge. This is
// floor(edge value at the row's first texel / change per texel). The quotient and the remainder are
// updated by constant steps from row to row.
class EdgeRows {
public:
    EdgeRows() = default;
    EdgeRows(const RasterEdge& edge, int64_t row) : divisor_(std::abs(edge.dy) * units) {
        const int64_t y = row * units + units / 2;
        const int64_t at_zero =
            edge.dx * (y - edge.ay) - edge.dy * (units / 2 - edge.ax) - edge.least();
        quotient_ = floor_div(at_zero, divisor_);
        remainder_ = at_zero - quotient_ * divisor_;
        quotient_step_ = floor_div(edge.dx * units, divisor_);
        remainder_step_ = edge.dx * units - quotient_step_ * divisor_;
    }

    // Returns the value for the next row: the last inside texel of a rising edge, or minus the
    // first inside texel of a falling edge.
    int64_t next() {
        const int64_t here = quotient_;
        const int64_t rest = remainder_ + remainder_step_ - divisor_;
        const int64_t less = rest >> 63;  // -1 if rest < 0, else 0; a branch is unpredictable
        quotient_ += quotient_step_ + 1 + less;
        remainder_ = rest + (divisor_ & less);
        return here;
    }

private:
    int64_t divisor_ = 1, quotient_ = 0, remainder_ = 0, quotient_step_ = 0, remainder_step_ = 0;
};

// Calls take(texel, count) for the texels of each row between the edges. The number of edges is a
// template parameter, so that their state stays in registers.
template <size_t lefts, size_t rights, class Take>
void each_row(std::array<EdgeRows, 2> left, std::array<EdgeRows, 2> right, const TexelRect& rect,
              const Interval& rows, const Interval& columns, Take take) {
    int64_t texel = (rows.low - rect.y) * rect.width - rect.x;
    for (int64_t rest = rows.high - rows.low; rest >= 0; --rest) {
        Interval row = columns;
        for (size_t i = 0; i < lefts; ++i)
            row.low = std::max(row.low, -left[i].next());
        for (size_t i = 0; i < rights; ++i)
            row.high = std::min(row.high, right[i].next());
        if (!row.empty())
            take(static_cast<size_t>(texel + row.low), static_cast<size_t>(row.high - row.low + 1));
        texel += rect.width;
    }
}

template <class Box>
bool has_texels(const Box& box) {
    return box.low <= box.high;
}

// Returns the rows of [first, first + count) with centres between the lowest and the highest corner
// of the triangle, excluding centres on a horizontal top edge.
template <class Triangle>
Interval centres_within(const Triangle& t, uint32_t first, uint32_t count) {
    const auto [low, high] = std::minmax({t.y[0], t.y[1], t.y[2]});
    int64_t below = int64_t{high} - units / 2;
    for (size_t k = 0; k < 3; ++k)
        if (t.y[k] == high && t.y[(k + 1) % 3] == high) --below;
    return {std::max<int64_t>(texel_at(int64_t{low} + units / 2 - 1), first),
            std::min<int64_t>(texel_at(below), int64_t{first} + count - 1)};
}

// std::fill_n() for small counts.
void fill_span(uint32_t* owners, size_t count, uint32_t index) {
    const std::array<uint32_t, 4> four = {index, index, index, index};
    if (count < four.size()) {
        for (size_t i = 0; i < count; ++i)
            owners[i] = index;
        return;
    }
    for (size_t i = 0; i + four.size() <= count; i += four.size())
        std::memcpy(owners + i, four.data(), sizeof four);
    std::memcpy(owners + count - four.size(), four.data(), sizeof four);
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
    find_group_rows();
    if (across_ > 1) find_borders();
}

UvRaster::Texels UvRaster::texels_of(const int32_t (&places)[3]) {
    const auto [low, high] = std::minmax({places[0], places[1], places[2]});
    return {static_cast<int32_t>(texel_at(low)), static_cast<int32_t>(texel_at(high))};
}

void UvRaster::add(const Mesh& mesh, size_t index) {
    Triangle t;
    if (!has_uv_area(mesh, index)) return;
    for (size_t k = 0; k < 3; ++k) {
        const glm::dvec2 uv(mesh.uvs[0][mesh.indices[3 * index + k]]);
        const double x = (uv.x - layout_.corner.x) * layout_.width * units;
        const double y = (uv.y - layout_.corner.y) * layout_.height * units;
        if (!(std::fabs(x) < furthest) || !(std::fabs(y) < furthest)) return;
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
        const Interval columns = covered_range(triangles_[i].columns, 0, layout_.width);
        const Interval rows = covered_range(rows_[i], 0, layout_.height);
        if (!columns.empty() && !rows.empty())
            held += (columns.high - columns.low + 1) * (rows.high - rows.low + 1);
    }
    if (held <= many * all) return;
    each_third_repeat(triangles_, [&](uint32_t index) {
        triangles_[index].columns = {};
        rows_[index] = {};
    });
}

void UvRaster::find_group_rows() {
    group_rows_.resize((rows_.size() + group - 1) / group);
    for (size_t i = 0; i < rows_.size(); ++i) {
        Texels& all = group_rows_[i / group];
        const bool first = all.low > all.high;
        if (rows_[i].low > rows_[i].high) continue;
        all.low = first ? rows_[i].low : std::min(all.low, rows_[i].low);
        all.high = std::max(all.high, rows_[i].high);
    }
}

void UvRaster::find_borders() {
    std::vector<UvEdge> edges;
    edges.reserve(3 * triangles_.size());
    for (uint32_t i = 0; i < triangles_.size(); ++i)
        for (uint8_t k = 0; k < 3; ++k)
            if (has_texels(rows_[i])) edges.push_back(uv_edge(triangles_[i], i, k));
    std::sort(edges.begin(), edges.end(),
              [](const UvEdge& a, const UvEdge& b) { return a.key() < b.key(); });
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
    const auto low = static_cast<int32_t>(y), high = static_cast<int32_t>(y + height - 1);
    const auto meets = [&](const Texels& rows) { return rows.high >= low && rows.low <= high; };
    std::vector<RowCandidate> found;
    for (size_t first = 0; first < rows_.size(); first += group) {
        if (!meets(group_rows_[first / group])) continue;
        for (size_t i = first; i < std::min(first + group, rows_.size()); ++i) {
            const Texels& columns = triangles_[i].columns;
            if (meets(rows_[i]) && !covered_range(columns, 0, layout_.width).empty())
                found.push_back({static_cast<uint32_t>(i), columns.low, columns.high});
        }
    }
    return found;
}

// Branch-free, as a branch per candidate is unpredictable.
void UvRaster::find_overlapping(const TexelRect& rect, std::span<const RowCandidate> candidates,
                                Coverage& out) {
    const auto low = static_cast<int32_t>(rect.x);
    const auto high = static_cast<int32_t>(rect.x + rect.width - 1);
    out.met.resize(candidates.size());
    size_t count = 0;
    for (const RowCandidate& each : candidates) {
        out.met[count] = each.triangle;
        count += static_cast<size_t>(each.low <= high) & static_cast<size_t>(each.high >= low);
    }
    out.met.resize(count);
}

void UvRaster::cover(const TexelRect& rect, std::span<const RowCandidate> candidates,
                     Coverage& out) const {
    out.edges.clear();
    out.samples.clear();
    find_overlapping(rect, candidates, out);
    own_centres(rect, out);
    if (across_ == 1) return;
    out.slots.assign(out.owners.size(), Coverage::none);
    for (const uint32_t index : out.met)
        if (triangles_[index].borders) mark_borders(rect, index, out);
    uint32_t count = 0;
    for (uint32_t& slot : out.slots)
        if (slot == marked) slot = count++;
    if (count == 0) return;
    out.sub_owners.assign(size_t{count} * layout_.samples, Coverage::none);
    for (const uint32_t index : out.met)
        own_samples(rect, index, out);
    gather_edges(rect, out);
}

template <class Take>
void UvRaster::each_span(const TexelRect& rect, uint32_t index, Take take) const {
    const Triangle& t = triangles_[index];
    const Interval columns = covered_range(t.columns, rect.x, rect.width);
    const Interval rows = centres_within(t, rect.y, rect.height);
    if (rows.empty()) return;
    std::array<EdgeRows, 2> left, right;
    size_t lefts = 0, rights = 0;
    for (size_t k = 0; k < 3; ++k) {
        const RasterEdge edge = edge_of(t, k);
        if (edge.dy < 0) left[lefts++] = EdgeRows(edge, rows.low);
        if (edge.dy > 0) right[rights++] = EdgeRows(edge, rows.low);
    }
    if (lefts == 2)
        each_row<2, 1>(left, right, rect, rows, columns, take);
    else if (rights == 2)
        each_row<1, 2>(left, right, rect, rows, columns, take);
    else
        each_row<1, 1>(left, right, rect, rows, columns, take);
}

void UvRaster::own_centres(const TexelRect& rect, Coverage& out) const {
    out.owners.assign(size_t{rect.width} * rect.height, Coverage::none);
    out.overlapped = 0;
    out.overlap_triangle = Coverage::none;
    size_t taken = 0;
    for (const uint32_t index : out.met) {
        each_span(rect, index, [&](size_t first, size_t count) {
            fill_span(out.owners.data() + first, count, index);
            taken += count;
        });
        if (taken > out.owners.size()) return own_in_order(rect, out);  // triangles overlap
    }
    const auto empty = std::count(out.owners.begin(), out.owners.end(), Coverage::none);
    out.owned = out.owners.size() - static_cast<size_t>(empty);
    if (taken != out.owned) own_in_order(rect, out);
}

// Repeats the ownership pass in mesh order if triangles overlap: the first one owns.
void UvRaster::own_in_order(const TexelRect& rect, Coverage& out) const {
    std::fill(out.owners.begin(), out.owners.end(), Coverage::none);
    out.open.open_all(out.owners.size());
    const auto take = [&out](uint32_t index, size_t texel) {
        uint32_t& owner = out.owners[texel];
        if (owner == Coverage::none) {
            owner = index;
            return;
        }
        out.open.close(texel);
        if (out.overlapped++ == 0 || texel < out.overlap_texel) {
            out.overlap_texel = static_cast<uint32_t>(texel);
            out.overlap_triangle = index;
        }
    };
    for (const uint32_t index : out.met)
        each_span(rect, index, [&](size_t first, size_t count) {
            const size_t end = first + count;
            for (size_t texel = out.open.from(first); texel < end; texel = out.open.from(texel + 1))
                take(index, texel);
        });
    const auto empty = std::count(out.owners.begin(), out.owners.end(), Coverage::none);
    out.owned = out.owners.size() - static_cast<size_t>(empty);
}

}  // namespace wrinkle
