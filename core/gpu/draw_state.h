// What GL and a material's program are told before a picture is drawn.
#pragma once

#include "gpu/object_space.h"
#include "gpu/program.h"
#include "gpu/renderer.h"

namespace wrinkle::gpu {

void set_view_uniforms(const Program& program, const Scene& scene, const ViewOptions& options,
                       const ObjectSpace& space);

// Binds the target; the whole of it becomes the background, or 0 of raw values.
void clear(const Target& target, const Scene& scene, bool raw);

// Opaque, both sides, depth tested; of a mirrored object the front is wound the other way.
void set_raster_state(bool mirrored);

// Sees the surroundings as if they had not been turned.
OrbitCamera turned(const Scene& scene);

// Edges in front of the triangles they belong to.
void set_edges(bool on);

}  // namespace wrinkle::gpu
