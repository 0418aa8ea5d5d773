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

// Returns no image on failure: reports an error of the graph or the mesh, or sets `environment`.
// `cache` may be null; the key of its entry is `inputs` and the driver. Precondition: test.render
// is set, and compile_case() reported no error.
DrawnCase draw_case(const TestCase& test, const CaseMaterial& material, Cache* cache,
                    const std::string& inputs, Diagnostics& diagnostics);

}  // namespace wrinkle::cli
