// Supersampling of texels that an island border crosses. Part of mesh/uv_raster.h.
#include <algorithm>

#include "mesh/uv_raster.h"
#include "mesh/uv_raster_parts.h"

namespace wrinkle {

void UvRaster::mark_borders(const TexelRect& rect, uint32_t index, Coverage& out) const {
    const Triangle& t = triangles_[index];
    for (size_t k = 0; k < 3; ++k) {
        if (!(t.borders >> k & 1U)) continue;
        const RasterEdge edge = edge_of(t, k);
        const int64_t low = std::min(edge.ay, edge.ay + edge.dy);
        const int64_t high = std::max(edge.ay, edge.ay + edge.dy);
        const int64_t last = std::min(texel_at(high), int64_t{rect.y} + rect.height - 1);
        for (int64_t y = std::max<int64_t>(texel_at(low), rect.y); y <= last; ++y) {
            const auto x_at = [&](int64_t at) {
                return edge.ax + floor_div(edge.dx * (std::clamp(at, low, high) - edge.ay) *
                                               (edge.dy < 0 ? -1 : 1),
                                           std::max<int64_t>(std::abs(edge.dy), 1));
            };
            const int64_t from = edge.dy == 0 ? edge.ax : x_at(y * units);
            const int64_t to = edge.dy == 0 ? edge.ax + edge.dx : x_at((y + 1) * units);
            const int64_t left = texel_at(std::min(from, to) - 1);  // floor_div rounding margin
            const int64_t right = texel_at(std::max(from, to) + 1);
            for (int64_t x = std::max<int64_t>(left, rect.x);
                 x <= std::min(right, int64_t{rect.x} + rect.width - 1); ++x)
                out.slots[static_cast<size_t>((y - rect.y) * rect.width + x - rect.x)] = marked;
        }
    }
}

void UvRaster::own_samples(const TexelRect& rect, uint32_t index, Coverage& out) const {
    const Triangle& t = triangles_[index];
    const RasterEdge edges[] = {edge_of(t, 0), edge_of(t, 1), edge_of(t, 2)};
    const TexelRange rows = rows_[index].within(rect.y, rect.height);
    const TexelRange columns = t.columns.within(rect.x, rect.width);
    const int64_t step = units / across_;
    const auto covers = [&](int64_t x, int64_t y) {
        return edges[0].has_inside(x, y) && edges[1].has_inside(x, y) && edges[2].has_inside(x, y);
    };
    for (int64_t y = rows.low; y <= rows.high; ++y)
        for (int64_t x = columns.low; x <= columns.high; ++x) {
            const uint32_t slot =
                out.slots[static_cast<size_t>((y - rect.y) * rect.width + x - rect.x)];
            if (slot == Coverage::none) continue;
            uint32_t* owners = out.sub_owners.data() + size_t{slot} * layout_.samples;
            for (uint32_t i = 0; i < layout_.samples; ++i)
                if (owners[i] == Coverage::none &&
                    covers(x * units + step / 2 + i % across_ * step,
                           y * units + step / 2 + i / across_ * step))
                    owners[i] = index;
        }
}

void UvRaster::gather_edges(const TexelRect& rect, Coverage& out) const {
    const double step = 1.0 / across_;
    for (uint32_t texel = 0; texel < out.slots.size(); ++texel) {
        if (out.slots[texel] == Coverage::none) continue;
        const uint32_t* owners = out.sub_owners.data() + size_t{out.slots[texel]} * layout_.samples;
        const auto covered = static_cast<uint32_t>(
            layout_.samples - std::count(owners, owners + layout_.samples, Coverage::none));
        const bool whole = covered == layout_.samples && out.owners[texel] != Coverage::none;
        if (covered == 0 || whole) continue;
        out.owned -= out.owners[texel] != Coverage::none;
        out.owners[texel] = Coverage::none;
        out.edges.push_back({texel, static_cast<uint32_t>(out.samples.size()), covered});
        for (uint32_t i = 0; i < layout_.samples; ++i)
            if (owners[i] != Coverage::none)
                out.samples.push_back({owners[i],
                                       {rect.x + texel % rect.width + (0.5 + i % across_) * step,
                                        rect.y + texel / rect.width + (0.5 + i / across_) * step}});
    }
}

}  // namespace wrinkle
