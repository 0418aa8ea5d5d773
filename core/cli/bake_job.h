// A bake made ready: what is baked onto which squares of uv into which files.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "bake/map_files.h"
#include "cli/bake_options.h"
#include "cli/material_run.h"
#include "cpu/texture_store.h"
#include "mesh/mesh.h"

namespace wrinkle::cli {

// A run of a sweep on a square of uv: its maps come from one pass.
struct BakePicture {
    size_t run = 0;  // in BakeJob::plans
    glm::ivec2 square{0};
    std::string suffix;  // ".003.1001": before the extensions of its files
};

struct BakeJob {
    BakeOptions options;
    BakeWishes wishes;
    Mesh mesh;
    TextureStore textures;
    std::vector<BakePlan> plans;  // one a run; their maps differ in nothing but values
    std::vector<BakePicture> pictures;
    std::vector<std::string> inputs;  // every file that was read
    std::string identity;  // the sum of all that the bytes depend on; of shards and --resume

    uint32_t bands() const { return (wishes.height + bake_tile - 1) / bake_tile; }  // a picture
};

// Nothing with errors. Warnings tell of what the mesh's uvs will not do.
std::optional<BakeJob> make_bake_job(const BakeOptions& options, const BakeWishes& wishes,
                                     Diagnostics& diagnostics);

}  // namespace wrinkle::cli
