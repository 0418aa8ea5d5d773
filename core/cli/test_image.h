// Draws the image of a render case, or takes it from a cache.
#pragma once

#include <optional>
#include <string>

#include "cli/cache.h"
#include "cli/material_run.h"
#include "cli/test_case.h"

namespace wrinkle::cli {

struct CaseToDraw {
    const TestCase& test;  // with a render case
    const MaterialRun& screen;
    const MaterialRun* given;  // with given differentials; needed if the mesh is displaced
    const Shader& shader;
    const TextureStore& textures;
    const CommonOptions& common;
};

struct DrawnCase {
    std::optional<Image> image;  // empty on failure
    std::string driver;
    std::string environment;  // why OpenGL is not available, one sentence, or ""
};

// Returns no image and reports an error of the graph or the mesh on failure. `cache` may be null;
// `inputs` is the hash of all files that the case reads. An entry belongs to these and the driver.
DrawnCase draw_case(const CaseToDraw& it, Cache* cache, const std::string& inputs,
                    Diagnostics& diagnostics);

}  // namespace wrinkle::cli
