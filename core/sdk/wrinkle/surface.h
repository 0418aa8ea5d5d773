// Properties of the surface point, in object space: surface::position, surface::normal,
// surface::uv0, ... They serve as values in a body and as defaults of ports.
#pragma once

#include "wrinkle/math.h"

namespace wrinkle::sdk::surface {

template <class T>
struct Property {
    uint32_t input;
    operator T() const { return T(builder ? Raw{builder->surface(builder, input)} : Raw{}); }
};

// Hidden, because gcc makes such symbols unique in the process (STB_GNU_UNIQUE), and a library that
// defines one is never unloaded.
#pragma GCC visibility push(hidden)
inline constexpr Property<vec3> position{WR_SURFACE_position};
inline constexpr Property<vec3> normal{WR_SURFACE_normal};
// Normal of the front face, not changed by the graph's rule for back faces; not valid as a port's
// default.
inline constexpr Property<vec3> front_normal{WR_SURFACE_FRONT_NORMAL};
inline constexpr Property<vec4> tangent{WR_SURFACE_tangent};
inline constexpr Property<vec2> uv0{WR_SURFACE_uv0};
inline constexpr Property<vec2> uv1{WR_SURFACE_uv1};
inline constexpr Property<vec2> uv2{WR_SURFACE_uv2};
inline constexpr Property<vec2> uv3{WR_SURFACE_uv3};
inline constexpr Property<vec4> color0{WR_SURFACE_color0};
inline constexpr Property<vec3> view{WR_SURFACE_view};
inline constexpr Property<Float> facing{WR_SURFACE_facing};
#pragma GCC visibility pop

// Overloads of the functions of math.h that read a property: normalize(surface::normal).
namespace detail {
template <class T>
T value_of(Property<T> property) {
    return property;
}
template <class T>
const T& value_of(const T& value) {
    return value;
}
}  // namespace detail
// clang-format off
#define WRINKLE_OF_PROPERTY(name) \
    template <class T, class... More> \
    auto name(Property<T> property, const More&... more) { \
        return sdk::name(detail::value_of(property), detail::value_of(more)...); \
    }
WRINKLE_OF_PROPERTY(abs) WRINKLE_OF_PROPERTY(sign) WRINKLE_OF_PROPERTY(floor)
WRINKLE_OF_PROPERTY(ceil) WRINKLE_OF_PROPERTY(fract) WRINKLE_OF_PROPERTY(exp)
WRINKLE_OF_PROPERTY(exp2) WRINKLE_OF_PROPERTY(sin) WRINKLE_OF_PROPERTY(cos)
WRINKLE_OF_PROPERTY(tan) WRINKLE_OF_PROPERTY(asin) WRINKLE_OF_PROPERTY(acos)
WRINKLE_OF_PROPERTY(atan) WRINKLE_OF_PROPERTY(ddx) WRINKLE_OF_PROPERTY(ddy)
WRINKLE_OF_PROPERTY(fwidth) WRINKLE_OF_PROPERTY(min) WRINKLE_OF_PROPERTY(max)
WRINKLE_OF_PROPERTY(clamp) WRINKLE_OF_PROPERTY(saturate) WRINKLE_OF_PROPERTY(mix)
WRINKLE_OF_PROPERTY(mod) WRINKLE_OF_PROPERTY(divide) WRINKLE_OF_PROPERTY(sqrt)
WRINKLE_OF_PROPERTY(inversesqrt) WRINKLE_OF_PROPERTY(log) WRINKLE_OF_PROPERTY(log2)
WRINKLE_OF_PROPERTY(pow) WRINKLE_OF_PROPERTY(dot) WRINKLE_OF_PROPERTY(length)
WRINKLE_OF_PROPERTY(distance) WRINKLE_OF_PROPERTY(normalize) WRINKLE_OF_PROPERTY(reflect)
WRINKLE_OF_PROPERTY(detach)
#undef WRINKLE_OF_PROPERTY
// clang-format on

}  // namespace wrinkle::sdk::surface
