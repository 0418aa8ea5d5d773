// The loops over the lanes of a tile, compiled once for each instruction set. Part of evaluate().
//
// kernel_bodies.h, fused_bodies.h, sample_bodies.h and interpolate_bodies.h hold the code; a file
// for each set includes them with WRINKLE_ISA as the set's name. Nothing in them may be an inline
// function with external linkage: the linker would keep one of the copies for all.
#pragma once

#include <type_traits>

#include "cpu/evaluate.h"
#include "cpu/interpolate.h"
#include "cpu/step_loops.h"
#include "cpu/texels.h"

namespace wrinkle {

inline constexpr size_t tile_lanes = 256;

// Where the lanes of each register of a tile stand.
template <class T>
struct Registers {
    T* const* floats;
    uint32_t* const* integers;
};

// Runs a step of kind `op`, `pair` or `depth` on the first n lanes.
template <class T>
using StepKernel = void (*)(const Step& step, const Registers<T>& registers, size_t n);

// The first channels of a level at n places, filtered bilinearly, as Texture::sample_lod<float>()
// has them, less `bias`; out[channel][lane].
using SampleLevel = void (*)(const TexelLevel& level, float bias, const float* u, const float* v,
                             float* const* out, size_t n);

// By number; null where an op has no case.
template <class T>
using StepLoops = std::array<StepKernel<T>, loop_count>;

struct Kernels {
    const StepLoops<float>& (*of_float)();
    const StepLoops<double>& (*of_double)();
    // For the first 1 to 4 of the channels that the level stores; more may be written of a packed
    // one.
    SampleLevel (*sample_level)(const TexelLevel& level, Wrap wrap, size_t channels);
    Interpolate interpolate;
};

template <class T>
const StepLoops<T>& loops_of(const Kernels& kernels) {
    if constexpr (std::is_same_v<T, float>)
        return kernels.of_float();
    else
        return kernels.of_double();
}

namespace baseline {
extern const Kernels kernels;
}
namespace avx2 {
extern const Kernels kernels;
}
namespace avx512 {
extern const Kernels kernels;
}

const Kernels& kernels_of(InstructionSet set);

}  // namespace wrinkle
