// Bakes one texture set, the maps of one UDIM tile: passes encoded rows of each map to a sink, from
// the top down, and collects statistics for warnings.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "bake/map_files.h"
#include "bake/maps.h"
#include "base/diagnostics.h"

namespace wrinkle {

struct TextureSetInput {
    const Mesh* mesh = nullptr;  // with uv0 and the attributes that the program reads
    const BakePlan* plan = nullptr;
    std::span<const Texture> textures;  // by index of BakePlan::resources
    std::vector<PixelType> types;       // pixel types of the files, by map
    UvLayout layout;
    uint32_t dilate = 16;
    uint32_t threads = 0;  // 0: one per core
};

// Findings over the texture sets of a bake.
struct BakeReport : BakeStatistics {
    std::vector<Clamped> clamped;  // values beyond the range of integers, by map

    // Appends the findings as warnings; `graph` and `mesh` are the file names as given by the user.
    void append_warnings(const std::string& graph, const std::string& mesh,
                         std::span<const BakedMap> maps, Diagnostics& warnings) const;
};

// Return false from either to cancel the bake.
struct BakeSinks {
    // Receives the next rows of one map, in its pixel type.
    std::function<bool(size_t map, std::span<const std::byte> rows)> rows;
    // Called after the rows of all maps of a band, with the band's end row (exclusive) and its
    // texel count.
    std::function<bool(uint32_t row, uint64_t texels)> band;
};

// Bakes rows [first, last) as bake_rows() does, and adds to `report`. Returns false if a sink
// cancelled.
bool bake_texture_set(const TextureSetInput& input, uint32_t first, uint32_t last,
                      const BakeSinks& take, BakeReport& report);

}  // namespace wrinkle
