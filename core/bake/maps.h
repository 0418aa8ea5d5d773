// The maps of a bake: what the channels of each picture hold, and one program that computes what
// all of them need.
//
//   normal      and every other output of type normal: (n + 1) / 2, in the space asked for. Tangent
//               space is that of vertex tangents (mesh/mesh.h), or of the derived frame of uv0
//               where a mesh has none (ir/gradient_frame.h), decoded as shaders decode it: n is a
//               sum of T, B and N that are not normalised by themselves. Green is +v, or -v
//   derivative  of the bump that makes the output "normal" out of the surface: dh/du and dh/dv over
//               the map's own uv, heights in length units of object space
//   slopes      of the same bump, as `maketx --bumpslopes` writes them: b0_h b1_dhds b2_dhdt
//               b3_dhds2 b4_dhdt2 b5_dh2dsdt; slopes per texel of the map, t downwards. b0_h is the
//               output "height", or -1 where there is none. The last three are means: the products
//               of the slopes and their covariance in the texel, as far as the pictures that the
//               bump is read from know it (ir/normal_variance.h)
//   others      as the output says; a color in an integer file is sRGB-coded
//
// Two channels get a third, of zeros, in an integer file: there they would be gray and alpha.
//
// A bump steeper than 128 (of the surface normal) counts as that steep. Heights and slopes are
// divided by `scale`, slopes' products by its square; a derivative in an integer file is
// (d / scale + 1) / 2. A packed map holds channels of the others, a color's linear.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "cpu/evaluate.h"
#include "image/image.h"
#include "ir/expand.h"

namespace wrinkle {

struct PackedChannel {
    char to = 'r';         // r, g, b or a
    std::string map;       // "roughness"
    uint32_t channel = 0;  // of that map
};

// "r=occlusion g=roughness b=metalness", "orm: r=...", "r=normal.g"; nothing with an error.
struct MapRequest {
    std::string name;
    std::vector<PackedChannel> pack;  // empty: the map of that name
    bool integers = true;             // of the file
};
std::optional<MapRequest> parse_pack(const std::string& text, Diagnostics& diagnostics);
std::string text_of(const MapRequest& pack);  // "orm: r=occlusion g=roughness.g"

struct MapOptions {
    bool tangent_space = true;  // else object space
    bool vertex_tangents = true;
    bool green_down = false;
    double scale = 1;
    uint32_t width = 1024, height = 1024;  // of the layout
};

// stored = lane * gain + offset, then sRGB-coded.
struct MapChannel {
    std::string name;
    uint32_t lane = 0;  // of the plan
    float gain = 1;
    float offset = 0;
    bool srgb = false;
    float empty = 0;  // stored where there is no surface
};

struct BakedMap {
    std::string name;
    std::vector<MapChannel> channels;
    bool has_alpha = false;
};

struct BakePlan {
    Program program;
    std::vector<Resource> resources;  // that the program samples
    size_t lanes = 0;                 // of all outputs of the program
    std::vector<uint32_t> unit;       // first lanes of vectors that stay unit when texels are mixed
    std::vector<BakedMap> maps;       // as requested
};

// The names of all maps that a graph with these outputs has: they and what is made of "normal".
std::vector<std::string> map_names(std::vector<std::string> outputs);

// Whether integers can hold a map of this name.
bool fits_integers(std::string_view map);

// What plan_maps() needs to be kept in the module for these maps.
Covariances covariances_for(const std::vector<MapRequest>& requests);

// Nothing with errors. The module was compiled with given differentials, and with the above.
std::optional<BakePlan> plan_maps(const Module& module, const std::vector<MapRequest>& requests,
                                  const MapOptions& options, Diagnostics& diagnostics);

// The stored numbers of `count` texels, interleaved; each lane is a plane of `count` numbers, one
// after the other. Where `covered` is 0 there is no surface.
void store_map(const BakedMap& map, const float* lanes, const uint8_t* covered, size_t count,
               float* stored);

}  // namespace wrinkle
