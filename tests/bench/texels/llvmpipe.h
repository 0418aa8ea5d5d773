// The job on an OpenGL driver (Mesa's llvmpipe if it is the only one): draws Wrinkle's generated
// GLSL over a complete RGBA8 target.
#pragma once

#include "bench/texels/job.h"
#include "emit/emit.h"

namespace wrinkle::bench {

// Draws `rounds` times and returns the median rate. Stores the result in `texels`, and an error in
// `why`. llvmpipe uses LP_NUM_THREADS threads as of process start.
Rate draw(const Shader& shader, int rounds, int threads, Packed& texels, std::string& why);

}  // namespace wrinkle::bench
