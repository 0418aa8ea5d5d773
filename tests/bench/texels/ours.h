// The job by Wrinkle's evaluator: the graph's program on planes that are filled row by row, and
// what comes out packed.
#pragma once

#include "bench/texels/job.h"
#include "bench/texels/kernel.h"
#include "cpu/evaluate.h"
#include "glsl/emit.h"

namespace wrinkle::bench {

struct Material {
    Program program;
    std::vector<Texture> textures;
    Shader shader;      // the same graph, differentials from the screen
    std::string error;  // "" where all of it was made
};
Material make_material();

// Rows first ... last - 1 into `out`, on the calling thread.
void evaluate_rows(const Material& material, InstructionSet set, const Kernel& ends, uint32_t first,
                   uint32_t last, uint32_t* out);

}  // namespace wrinkle::bench
