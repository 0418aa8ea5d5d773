// One picture of a bake: rows of all its maps as their files store them, and what is to be told of
// them when all is done.
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

struct PictureInput {
    const Mesh* mesh = nullptr;  // as BakeInput's
    const BakePlan* plan = nullptr;
    std::span<const Texture> textures;  // of the plan's resources
    std::vector<PixelType> types;       // of the files, by map
    UvLayout layout;
    uint32_t dilate = 16;
    uint32_t threads = 0;  // one for each core
};

// What was found in the pictures of a bake.
struct BakeReport {
    uint64_t overlapped = 0, not_finite = 0;  // texels
    glm::dvec2 overlap_uv{0};                 // of one of them
    uint32_t overlap_triangle = 0;            // that is hidden there
    std::vector<Clamped> clamped;             // by map

    void add(const BakeFindings& found, const UvLayout& layout);
    // As warnings; the files are named as the user calls them.
    void tell(const std::string& graph, const std::string& mesh, std::span<const BakedMap> maps,
              Diagnostics& warnings) const;
};

// False from either stops the bake.
struct PictureTakers {
    std::function<bool(size_t map, std::span<const std::byte> rows)> rows;
    // After those of all maps: down to which row, without it, and how many texels these were.
    std::function<bool(uint32_t row, uint64_t texels)> band;
};

// Rows `first` to `last` as bake_rows() has them; false when it was stopped.
bool bake_picture(const PictureInput& input, uint32_t first, uint32_t last,
                  const PictureTakers& take, BakeReport& report);

}  // namespace wrinkle
