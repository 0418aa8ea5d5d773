// Kernels over the points of a tile, compiled once per instruction set. Part of evaluate().
//
// The code is in kernel_bodies.h, fused_bodies.h, sample_bodies.h and interpolate_bodies.h; one
// file per instruction set includes them with WRINKLE_ISA defined as the set's name. They must not
// define inline functions with external linkage: the linker would use one of the copies for all
// sets.
#pragma once

#include <type_traits>

#include "cpu/evaluate.h"
#include "cpu/interpolate.h"
#include "cpu/kernel_table.h"
#include "cpu/packed_mip_chain.h"

namespace wrinkle {

inline constexpr size_t tile_points = 512;
// Kernels run on blocks of lanes. A uniform register is one block, which kernels read repeatedly,
// so that constants stay in the L1 cache.
inline constexpr size_t block_lanes = 32;
static_assert(tile_points % block_lanes == 0);
constexpr size_t padded_to_blocks(size_t points) {
    return (points + block_lanes - 1) / block_lanes * block_lanes;
}

// Pointers to the lanes of each register of a tile.
template <class T>
struct Registers {
    T* const* floats;
    uint32_t* const* integers;
    const uint32_t* active;  // by lane: 1 if the innermost loop is active in it, else 0
};

// Runs a step that has a kernel on the first n lanes, a multiple of block_lanes.
template <class T>
using InstKernel = void (*)(const CpuInst& step, const Registers<T>& registers, size_t n);

// Samples the first channels of a level at n points with bilinear filtering, as
// Texture::sample_lod<float>() does; out[channel][lane].
using SampleLevel = void (*)(const TexelLevel& level, const float* u, const float* v,
                             float* const* out, size_t n);

// Indexed by kernel_index(); null if an op has no kernel.
template <class T>
using KernelTable = std::array<InstKernel<T>, kernel_count>;

struct Kernels {
    const KernelTable<float>& (*of_float)();
    const KernelTable<double>& (*of_double)();
    // Returns the function for the first 1 to 4 of the channels that the level stores; for a packed
    // level it may write more channels than requested.
    SampleLevel (*sample_level)(const TexelLevel& level, Wrap wrap, size_t channels);
    Interpolate interpolate;
    void (*encode_srgb)(float* values, size_t n);  // srgb_from_linear() of each, rounded once
};

template <class T>
const KernelTable<T>& kernel_table(const Kernels& kernels) {
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
