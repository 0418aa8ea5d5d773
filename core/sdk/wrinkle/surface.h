// Properties of the surface point, in object space: surface::position, surface::normal,
// surface::uv0, ... They serve as values in a body and as defaults of ports.
#pragma once

#include "wrinkle/value.h"

namespace wrinkle::sdk::surface {

template <class T>
struct Property {
    uint32_t input;
    operator T() const { return T(builder ? Raw{builder->surface(builder, input)} : Raw{}); }
};

// Hidden: gcc makes one of equal names in all libraries of a process, which then stay loaded.
#pragma GCC visibility push(hidden)
inline constexpr Property<vec3> position{WR_SURFACE_position};
inline constexpr Property<vec3> normal{WR_SURFACE_normal};
// As the front face has it, whatever the graph's rule for back faces; no default of a port.
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

}  // namespace wrinkle::sdk::surface
