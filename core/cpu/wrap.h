// Maps texture coordinates of any size to texels by wrap mode. Always inlined, because files of all
// instruction sets include it.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "base/texture_options.h"
#include "base/transcendental.h"

namespace wrinkle {

// Returns a coordinate in [0, 1] by the wrap mode (with clamp, texel_index() handles the half texel
// at the border); 0 for NaN and for |x| >= 1e9.
template <Wrap wrap, class T>
[[gnu::always_inline]] inline T wrapped(T x) {
    const T near = std::fabs(x) < T(1e9) ? x : T(0);
    if constexpr (wrap == Wrap::repeat) return near - math::floor(near);
    if constexpr (wrap == Wrap::clamp) return near < 0 ? T(0) : near > 1 ? T(1) : near;
    const T period = near - 2 * math::floor(near / 2);
    return period > 1 ? 2 - period : period;
}

// Wraps texel index i, at most one outside of [0, size).
template <Wrap wrap, class Int>
[[gnu::always_inline]] inline Int texel_index(Int i, Int size) {
    if constexpr (wrap == Wrap::repeat) return i < 0 ? i + size : i >= size ? i - size : i;
    return i < 0 ? 0 : i >= size ? size - 1 : i;
}

// Calls f with the wrap mode as a constant, an std::integral_constant.
template <class F>
[[gnu::always_inline]] inline auto with_wrap(Wrap wrap, F f) {
    switch (wrap) {
        case Wrap::repeat:
            return f(std::integral_constant<Wrap, Wrap::repeat>());
        case Wrap::clamp:
            return f(std::integral_constant<Wrap, Wrap::clamp>());
        case Wrap::mirror:
            break;
    }
    return f(std::integral_constant<Wrap, Wrap::mirror>());
}

}  // namespace wrinkle
