// GL state and uniforms that are set before a mesh is drawn.
#pragma once

#include "gpu/object_space.h"
#include "gpu/program.h"
#include "gpu/renderer.h"

namespace wrinkle::gpu {

void set_view_uniforms(const Program& program, const Scene& scene, const ViewOptions& options,
                       const ObjectSpace& space);

// Binds the target and clears it to the background, or to 0 if `raw`; clears its depth.
void clear(const Target& target, const Scene& scene, bool raw);

// Opaque, no culling, depth test on; front faces are clockwise if the object is mirrored.
void set_raster_state(bool mirrored);

// Draws three vertices without attributes, for programs that cover the target by gl_VertexID.
void draw_covering_triangle();

// Switches drawing to triangle edges, with a depth offset in front of their triangles.
void set_edges(bool on);

}  // namespace wrinkle::gpu
