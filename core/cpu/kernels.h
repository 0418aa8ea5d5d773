// One step on a tile of lanes. Part of evaluate().
#pragma once

#include <cmath>
#include <cstdint>

#include "base/transcendental.h"
#include "cpu/evaluate.h"

namespace wrinkle {

inline constexpr size_t tile_lanes = 256;

template <class T>
struct Registers {
    std::vector<T> floats;
    std::vector<uint32_t> integers;

    T* f(uint32_t reg) { return floats.data() + reg * tile_lanes; }
    uint32_t* i(uint32_t reg) { return integers.data() + reg * tile_lanes; }
};

// Arithmetic of floats; false where the op is of another kind.
template <class T>
bool run_arithmetic(const Step& step, Registers<T>& r, size_t n);
template <class T>
bool run_transcendental(const Step& step, Registers<T>& r, size_t n);
template <class T>
bool run_comparison(const Step& step, Registers<T>& r, size_t n);
bool run_integer(const Step& step, uint32_t* out, const uint32_t* a, const uint32_t* b, size_t n);
template <class T>
bool run_conversion(const Step& step, Registers<T>& r, size_t n);

}  // namespace wrinkle
