// Programs that cover the bound target with one triangle: backgrounds, and passes over buffers.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics.h"
#include "gpu/camera.h"
#include "gpu/program.h"

namespace wrinkle::gpu {

// `fragment` declares functions and main(), which sets `vec4 WrView_color`. It may read `vec3
// WrView_direction`, the ray of a pixel in world space, of any length, if set_rays() sets it.
// Returns std::nullopt and reports the log if the driver rejects it.
std::optional<Program> link_covering(const std::string& fragment, Diagnostics& diagnostics);

void set_rays(const Program& program, const OrbitCamera& camera, float aspect);

// Draws with the program in use; its depth is that of the far plane.
void draw_covering_triangle();

}  // namespace wrinkle::gpu
