// The job written by hand with intrinsics: what an instruction set can do at best. Fused
// multiply-adds, gathers of whole texels. (The set's estimate of the reciprocal root and a Newton
// step were no faster than a root and a division, which other work hides.) Beside it what the
// evaluator's turn needs on both ends: planes filled by interpolation, and bytes.
#pragma once

#include "bench/texels/job.h"

namespace wrinkle::bench {

inline constexpr size_t most_planes = 8;
struct Plane {
    Affine value;
    float* out;
};

struct Kernel {
    // Rows first ... last - 1 of the picture `out`.
    void (*rows)(uint32_t first, uint32_t last, uint32_t* out);
    // Each value at `count` texels from (x, y) on, a multiple of 16.
    void (*fill)(const Plane* planes, size_t plane_count, uint32_t x, uint32_t y, uint32_t count);
    void (*pack)(const float* const* normal, uint32_t count, uint32_t* out);
};
namespace avx2 {
extern const Kernel kernel;
}
namespace avx512 {
extern const Kernel kernel;
}

}  // namespace wrinkle::bench
