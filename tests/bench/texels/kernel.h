// The job hand-written with intrinsics, with fused multiply-adds and gathers of complete texels: an
// upper bound for an instruction set. (An estimated reciprocal root with a Newton step was no
// faster than a root and a division, which other work hides.) Also the first and last stages of the
// evaluator's turn: planes filled by interpolation, and packed bytes.
#pragma once

#include "bench/texels/job.h"

namespace wrinkle::bench {

inline constexpr size_t max_planes = 8;
struct Plane {
    Affine value;
    float* out;
};

struct Kernel {
    // Writes rows first ... last - 1 of the image `out`.
    void (*rows)(uint32_t first, uint32_t last, uint32_t* out);
    // Fills each plane for `count` texels from (x, y) on; `count` is a multiple of 16.
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
