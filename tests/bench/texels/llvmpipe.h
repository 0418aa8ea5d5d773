// The job by an OpenGL driver, Mesa's llvmpipe where there is no other: Wrinkle's own GLSL for the
// graph, drawn over the whole of an RGBA8 target.
#pragma once

#include "bench/texels/job.h"
#include "glsl/emit.h"

namespace wrinkle::bench {

// Draws `rounds` times and keeps the median. `texels` is what came out; `why` says what failed. As
// many threads as LP_NUM_THREADS had when the process began.
Rate draw(const Shader& shader, int rounds, int threads, Packed& texels, std::string& why);

}  // namespace wrinkle::bench
