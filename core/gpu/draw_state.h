// GL state and uniforms that are set before a mesh is drawn.
#pragma once

#include "gpu/object_space.h"
#include "gpu/program.h"
#include "gpu/renderer.h"

namespace wrinkle::gpu {

void set_view_uniforms(const Program& program, const ViewOptions& options,
                       const ObjectSpace& space);

// Clears the bound target to the background, or to 0 if `raw`; clears its depth.
void clear(const Scene& scene, bool raw);

// Opaque, no culling, depth test on; front faces are clockwise if the object is mirrored.
void set_raster_state(bool mirrored);

// Switches drawing to triangle edges, with a depth offset in front of their triangles.
void set_edges(bool on);

}  // namespace wrinkle::gpu
