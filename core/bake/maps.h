// Plans the maps of a bake: the contents of their channels, and one program that computes the
// values of all of them.
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
    uint32_t channel = 0;  // in that map
};

// A requested map. parse_pack() reads "r=occlusion g=roughness b=metalness", "orm: r=...",
// "r=normal.g"; it returns std::nullopt and appends an error for other text.
struct MapRequest {
    std::string name;
    std::vector<PackedChannel> pack;  // empty: the map of that name
    bool integers = true;             // the file stores integers
};
std::optional<MapRequest> parse_pack(const std::string& text, Diagnostics& diagnostics);
std::string text_of(const MapRequest& pack);  // "orm: r=occlusion g=roughness.g"

struct MapOptions {
    bool tangent_space = true;  // false: object space
    bool vertex_tangents = true;
    bool green_down = false;
    double scale = 1;
    uint32_t width = 1024, height = 1024;  // size of the layout
};

// stored = lane * gain + offset, then sRGB-coded.
struct MapChannel {
    std::string name;
    uint32_t lane = 0;  // index below BakePlan::lanes
    float gain = 1;
    float offset = 0;
    bool srgb = false;
    float empty = 0;  // stored for a texel without a surface
};

struct BakedMap {
    std::string name;
    std::vector<MapChannel> channels;
    bool has_alpha = false;
};

struct BakePlan {
    Program program;
    std::vector<Resource> resources;  // sampled by the program
    size_t lanes = 0;                 // total of the program's outputs
    std::vector<uint32_t> unit;       // first lanes of unit vectors: renormalise averages
    std::vector<BakedMap> maps;       // as requested
};

// Returns the names of all maps of a graph with these outputs: the outputs, and the maps derived
// from "normal".
//
//   normal      and every other output of type normal: (m + 1) / 2, m a unit vector. Object space:
//               m is the normal n. Tangent space: n = normalize(m.x T + m.y B + m.z N) as shaders
//               decode it, with T, B and N not normalised individually; T and B are the vertex
//               tangents (mesh/mesh.h), or derived from uv0 if the mesh has none
//               (ir/gradient_frame.h). Green is +v, or -v (green_down)
//   derivative  of the bump that maps the surface normal to the output "normal": dh/du and dh/dv
//               over the map's own uv, heights in length units of object space
//   slopes      of the same bump, as written by `maketx --bumpslopes`: b0_h b1_dhds b2_dhdt
//               b3_dhds2 b4_dhdt2 b5_dh2dsdt; slopes per texel of the map, t downwards. b0_h is the
//               output "height", or -1 without that output. The last three are means: the products
//               of the slopes plus their covariance in the texel, as far as the textures of the
//               bump provide it (ir/normal_variance.h)
//   others      the value of the output; a color in an integer file is sRGB-coded
//
// Maps of two channels get a third one of zeros in an integer file; otherwise readers would
// interpret them as gray and alpha.
//
// The slope of a bump, relative to the surface, is limited to max_slope (base/normals.h). Heights
// and slopes are divided by `scale`, products of slopes by its square; a derivative in an integer
// file is (d / scale + 1) / 2. A packed map holds channels of other maps; those of a color are
// linear.
std::vector<std::string> map_names(std::vector<std::string> outputs);

// Returns true if integers can store a map of this name.
bool fits_integers(std::string_view map);

// Returns MaterialOptions::covariances (lower/material.h) for these maps.
Covariances covariances_for(const std::vector<MapRequest>& requests);

// Returns std::nullopt and appends diagnostics on failure; appends a warning if maps depend on the
// view. Precondition: the module was compiled with given differentials and
// covariances_for(requests).
std::optional<BakePlan> plan_maps(const Module& module, const std::vector<MapRequest>& requests,
                                  const MapOptions& options, Diagnostics& diagnostics);

// Encodes `count` texels to interleaved numbers; `lanes` holds one plane of `count` numbers per
// lane, consecutive. A texel with `covered` 0 has no surface.
void store_map(const BakedMap& map, const float* lanes, const uint8_t* covered, size_t count,
               float* stored);

}  // namespace wrinkle
