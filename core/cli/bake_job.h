// Prepared bake: mesh, compiled plans, UDIM tiles and output maps.
#pragma once

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

// One run of a sweep on one UDIM tile: its maps, which are baked in one pass.
struct TextureSet {
    size_t run = 0;  // index into BakeJob::plans
    glm::ivec2 square{0};
    std::string suffix;  // ".003.1001": inserted before the file extensions
};

struct BakeJob {
    BakeOptions options;
    BakeRequest request;
    Mesh mesh;
    TextureStore textures;
    std::vector<BakePlan> plans;  // one per run; their maps differ only in values
    std::vector<TextureSet> sets;
    std::vector<std::string> inputs;  // all files read
    std::string identity;  // hash of all that affects the bytes; set for shards and --resume

    uint32_t bands() const { return (request.height + bake_tile - 1) / bake_tile; }  // per image
};

// Returns std::nullopt and reports errors on failure. Problems of the mesh's uvs are warnings.
std::optional<BakeJob> make_bake_job(const BakeOptions& options, const BakeRequest& request,
                                     Diagnostics& diagnostics);

}  // namespace wrinkle::cli
