// Draws the image of a render case, or takes it from a cache.
#pragma once

#include <optional>
#include <string>

#include "cli/cache.h"
#include "cli/test_material.h"

namespace wrinkle::cli {

struct DrawnCase {
    std::optional<Image> image;  // empty on failure
    std::string driver;
    std::string environment;  // why OpenGL is not available, one sentence, or ""
};

// Returns no image and reports an error of the graph or the mesh on failure. `cache` may be null;
// `inputs` is the hash of all files that the case reads. An entry belongs to these and the driver.
// Precondition: the case has an image, and compile_case() reported no error.
DrawnCase draw_case(const TestCase& test, const CaseMaterial& material, Cache* cache,
                    const std::string& inputs, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
