// Edge profile of a tile: 1 on the tile, 0 in a groove `mortar` wide at its bottom, with slopes
// `bevel` wide; `inside` is the distance to the groove's middle. Slopes are box-filtered to the
// footprint; a groove narrower than a pixel becomes shallower, as by its box filter. Lengths are in
// tiles.
#pragma once

#include "nodes/constants.h"
#include "nodes/footprint.h"

namespace wrinkle::nodes {

struct Edges {
    sdk::Float mortar, bevel, footprint;

    sdk::Float groove() const { return mortar + bevel; }  // its width at half depth
    sdk::Float height(sdk::Float inside) const {
        const sdk::Float width = named("slope_width", max(bevel, footprint));
        const sdk::Float covered = named("covered", (0.5 * (width + groove()) - inside) / width);
        return 1 - clamp(covered, 0, named("deepest", min(1, groove() / width)));
    }
    // The mean over a tile of this length and of height 1.
    sdk::Float mean(sdk::Float length) const {
        return saturate(1 - groove()) * saturate(1 - groove() / length);
    }
    // The tile's height, fading to the mean as a pixel covers a tile.
    sdk::Float tile(sdk::Float inside, sdk::Float mean) const {
        return mix(mean_height(mean), height(inside), fade(footprint));
    }
};

template <class Declaration>
constexpr auto with_edges(const Declaration& declaration, double mortar, double bevel,
                          const char* tiles) {
    return declaration
        .template in<sdk::Float>("mortar", mortar, tiles, sdk::slider(0, 0.3), sdk::limits(0, 1))
        .template in<sdk::Float>("bevel", bevel,
                                 "Width of the slope on either side of it, likewise",
                                 sdk::slider(0.1, 0.5), sdk::limits(0.001, 1));
}

}  // namespace wrinkle::nodes
