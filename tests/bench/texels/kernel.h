// The job written by hand with intrinsics: what an instruction set can do at best. Fused
// multiply-adds, gathers of whole texels. (The instruction set's estimate of the reciprocal root and
// a Newton step were no faster than a root and a division, which other work hides.)
#pragma once

#include "bench/texels/job.h"

namespace wrinkle::bench {

// Rows first ... last - 1 of the picture `out`.
using Kernel = void (*)(uint32_t first, uint32_t last, uint32_t* out);
namespace avx2 {
void rows(uint32_t first, uint32_t last, uint32_t* out);
}
namespace avx512 {
void rows(uint32_t first, uint32_t last, uint32_t* out);
}

}  // namespace wrinkle::bench
