// The loops over the lanes of a tile, compiled once for each instruction set. Part of evaluate().
//
// kernel_bodies.h and sample_bodies.h hold the code; a file for each set includes them with
// WRINKLE_ISA as the set's name. Nothing in them may be an inline function with external linkage:
// the linker would keep one of the copies for all.
#pragma once

#include "cpu/evaluate.h"
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

struct Kernels {
    // By op and by the type of its operands' lanes; null where the op has no case.
    StepKernel<float> (*of_float)(Op op, Type type);
    StepKernel<double> (*of_double)(Op op, Type type);
    StepKernel<float> (*pair_of_float)(Op first, Op second, bool swapped);
    StepKernel<double> (*pair_of_double)(Op first, Op second, bool swapped);
    StepKernel<float> depth_of_float;
    StepKernel<double> depth_of_double;
    // For the first 1 to 4 of the channels that the level stores; more may be written of a packed one.
    SampleLevel (*sample_level)(const TexelLevel& level, Wrap wrap, size_t channels);
};

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
