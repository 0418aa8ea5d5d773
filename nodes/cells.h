// Outputs that nodes of cells share, after those of relief.h: they let each cell look different.
#pragma once

#include <tuple>

#include "nodes/footprint.h"
#include "nodes/random.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {

// Lengths are in units of the pattern, `scale` of which fit into a uv unit.
struct CellAt {
    sdk::vec2 cell;    // whole numbers
    sdk::vec2 way;     // from the centre
    sdk::vec2 size;    // the box around the cell
    sdk::Float edge;   // distance to the edge, positive inside
    sdk::Float width;  // footprint
};

// An offset of a square of `width` by `width` squares around 0.
inline sdk::vec2 offset2(sdk::Int index, double width) {
    using namespace sdk;
    const Float middle = named("middle", Float(index) + 0.5);
    const Float row = named("row", floor(middle / width));
    return vec2(floor(middle - row * width), row) - (width - 1) / 2;
}

template <class Declaration>
constexpr auto cell_outputs(const Declaration& declaration) {
    return declaration
        .template out<sdk::Float>("edge",
                                  "Distance to the edge of the cell, in cells; its slope is 1")
        .template out<sdk::vec2>("cell", "The cell: whole numbers, for random nodes")
        .template out<sdk::vec3>("random", "Three random numbers of the cell, 0 to below 1")
        .template out<sdk::vec2>("center", "The middle of the cell, on the uv set")
        .template out<sdk::vec2>("local",
                                 "Position in the cell, -0.5 to 0.5, with the slopes of the uv")
        .template out<sdk::vec2>("size", "Width and height of the cell, in uv units")
        .template out<sdk::Float>("detail", "1 near, 0 where a pixel covers a cell");
}

inline auto cell_values(const CellAt& at, sdk::vec2 uv, sdk::Float scale, int seed) {
    using namespace sdk;
    const vec2 center = uv - at.way / select(scale != 0, scale, 1);
    return std::tuple{at.edge,        at.cell,          random3(random_bits(at.cell, 0, seed)),
                      detach(center), at.way / at.size, at.size / select(scale != 0, scale, 1),
                      fade(at.width)};
}

}  // namespace wrinkle::nodes
