// One op on the lanes of a tile, compiled once for each instruction set. Part of evaluate().
//
// kernel_bodies.h holds the code; a file for each set includes it with WRINKLE_ISA as the set's
// name. Nothing in it may be an inline function with external linkage: the linker would keep one of
// the copies for all.
#pragma once

#include "cpu/evaluate.h"

namespace wrinkle {

inline constexpr size_t tile_lanes = 256;

// Where the registers of a tile stand: register r has its lanes from r * tile_lanes on.
template <class T>
struct Registers {
    T* floats;
    uint32_t* integers;
};

// Runs a step of kind `op` on the first n lanes. False where the op has no case.
template <class T>
using RunOp = bool (*)(const Step& step, const Registers<T>& registers, size_t n);

namespace baseline {
bool run_op(const Step& step, const Registers<float>& registers, size_t n);
bool run_op(const Step& step, const Registers<double>& registers, size_t n);
}  // namespace baseline

namespace avx2 {
bool run_op(const Step& step, const Registers<float>& registers, size_t n);
bool run_op(const Step& step, const Registers<double>& registers, size_t n);
}  // namespace avx2

}  // namespace wrinkle
