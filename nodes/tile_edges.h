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
    // The share of a tile of this width and height that has no groove.
    sdk::Float mean(sdk::vec2 size) const {
        return saturate(1 - groove() / size.y()) * saturate(1 - groove() / size.x());
    }
    // Its grooves per length across x and across y, without the corners where they cross.
    sdk::vec2 grooves(sdk::vec2 size) const {
        return {saturate(1 - groove() / size.y()) / size.x(),
                saturate(1 - groove() / size.x()) / size.y()};
    }
    // Returns the slope covariance (xx, yy, xy) that the filters remove from tiles of these
    // grooves. Close up, each groove has two slopes of 1 / bevel.
    sdk::vec3 lost(sdk::vec2 grooves) const {
        const sdk::Float width = max(bevel, footprint), near = fade(footprint);
        const sdk::Float retained = near * near * min(1, groove() / width) / width;
        const sdk::Float sloped = min(2 * bevel * (grooves.x() + grooves.y()), 1);
        return sdk::vec3(2 * sloped * (1 / bevel - retained) * grooves, 0);
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
