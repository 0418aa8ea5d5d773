// The job on Wrinkle's evaluator: runs the graph's program on planes filled row by row, and packs
// the results.
#pragma once

#include "bench/texels/job.h"
#include "bench/texels/kernel.h"
#include "cpu/evaluate.h"
#include "emit/emit.h"

namespace wrinkle::bench {

struct Material {
    Program program;
    std::vector<Texture> textures;
    Shader shader;      // the same graph, with screen differentials
    std::string error;  // "" on success
};
Material make_material();

// Writes rows first ... last - 1 to `out`, on the calling thread.
void evaluate_rows(const Material& material, InstructionSet set, const Kernel& ends, uint32_t first,
                   uint32_t last, uint32_t* out);

}  // namespace wrinkle::bench
