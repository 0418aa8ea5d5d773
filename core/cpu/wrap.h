// How coordinates of any size find their texels. For every instruction set, so always inlined.
#pragma once

#include <cmath>
#include <cstdint>

#include "base/texture_options.h"
#include "base/transcendental.h"

namespace wrinkle {

// A coordinate brought into [0, 1] by the wrap mode (clamp leaves room for the border's half
// texel); 0 for NaN and what is too large to have a place.
template <Wrap wrap, class T>
[[gnu::always_inline]] inline T wrapped(T x) {
    const T near = std::fabs(x) < T(1e9) ? x : T(0);
    if constexpr (wrap == Wrap::repeat) return near - math::floor(near);
    if constexpr (wrap == Wrap::clamp) return near < 0 ? T(0) : near > 1 ? T(1) : near;
    const T period = near - 2 * math::floor(near / 2);
    return period > 1 ? 2 - period : period;
}

// Texel i, at most one beside the level, of `size`.
template <Wrap wrap, class Int>
[[gnu::always_inline]] inline Int texel_index(Int i, Int size) {
    if constexpr (wrap == Wrap::repeat) return i < 0 ? i + size : i >= size ? i - size : i;
    return i < 0 ? 0 : i >= size ? size - 1 : i;
}

}  // namespace wrinkle
