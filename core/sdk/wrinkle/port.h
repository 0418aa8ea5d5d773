// How the ports of a node are described: types on wires, defaults, ranges, units.
//
// Types of ports: Float vec2 vec3 vec4 Gradient Derivative Image Material, and
//   Height  a Float: a length of object space, positive outward
//   Color   a vec3, linear
//   Normal  a vec3: unit, object space unless the port says otherwise
//
// Options that may follow the doc line, in any order:
//   slider(a, b)      the soft range, of the widget only
//   limits(a, b)      the hard range: values are clamped
//   unit("deg")       shown beside the value
//   encoding("srgb")  of an image given as a bare path
#pragma once

#include <concepts>
#include <type_traits>

#include "wrinkle/gradient.h"
#include "wrinkle/image.h"
#include "wrinkle/material.h"
#include "wrinkle/surface.h"

namespace wrinkle::sdk {

struct Height;
struct Color;
struct Normal;

// Wire type and body type of a port of type T; any other T is a compile error.
template <class T>
struct PortTraits {
    static_assert(
        !std::is_floating_point_v<T>,
        "write .in<Float> and .out<Float>: numbers of a node are Float, with a capital F");
    static_assert(!std::same_as<T, bool>, "write .flag(name, value, doc): a bool is not on a wire");
    static_assert(!std::is_integral_v<T> || std::same_as<T, bool>,
                  "write .count(name, value, low, high, doc): an integer is not on a wire");
    static_assert(std::is_arithmetic_v<T>,
                  "the type of a port is Float, vec2, vec3, vec4, Height, Color, Normal, Gradient, "
                  "Derivative, Image or Material");
    static constexpr uint32_t type = WR_PORT_float;
    using Value = Float;
};
// clang-format off
#define WRINKLE_PORT(T, name, Body) \
    template <> struct PortTraits<T> { \
        static constexpr uint32_t type = WR_PORT_##name; \
        using Value = Body; \
    };
WRINKLE_PORT(Float, float, Float)
WRINKLE_PORT(vec2, vec2, vec2)
WRINKLE_PORT(vec3, vec3, vec3)
WRINKLE_PORT(vec4, vec4, vec4)
WRINKLE_PORT(Color, color, vec3)
WRINKLE_PORT(Height, height, Float)
WRINKLE_PORT(Derivative, derivative, Derivative)
WRINKLE_PORT(Gradient, gradient, Gradient)
WRINKLE_PORT(Normal, normal, vec3)
WRINKLE_PORT(Image, image, Image)
WRINKLE_PORT(Material, material, Material)
#undef WRINKLE_PORT
// clang-format on

// A constant (one number sets every component) or a property of the surface.
struct Default {
    uint32_t kind = WR_DEFAULT_NONE;
    uint32_t surface = 0;
    double value[4] = {};

    constexpr Default() = default;
    constexpr Default(double all) : Default(all, all, all, all) {}
    constexpr Default(double x, double y, double z = 0, double w = 0)
        : kind(WR_DEFAULT_CONSTANT), value{x, y, z, w} {}
    template <class T>
    constexpr Default(surface::Property<T> property)
        : kind(WR_DEFAULT_SURFACE), surface(property.input) {}
};

struct slider {
    double low, high;
    constexpr slider(double a, double b) : low(a), high(b) {}
    constexpr void apply(wr_port& port) const { port.soft_min = low, port.soft_max = high; }
};
struct limits {
    double low, high;
    constexpr limits(double a, double b) : low(a), high(b) {}
    constexpr void apply(wr_port& port) const { port.hard_min = low, port.hard_max = high; }
};
struct unit {
    const char* text;
    explicit constexpr unit(const char* name) : text(name) {}
    constexpr void apply(wr_port& port) const { port.unit = text; }
};
struct encoding {
    const char* text;
    explicit constexpr encoding(const char* name) : text(name) {}
    constexpr void apply(wr_port& port) const { port.encoding = text; }
};

template <class T>
concept PortOption = requires(const T& option, wr_port& port) {
    option.apply(port);
};

constexpr wr_port make_port(uint32_t kind, uint32_t type, const char* name, const char* doc) {
    wr_port port{};
    port.size = sizeof(wr_port);
    port.kind = kind;
    port.type = type;
    port.name = name;
    port.doc = doc;
    port.unit = "";
    return port;
}

constexpr void set_default(wr_port& port, const Default& value) {
    port.default_kind = value.kind;
    if (value.kind == WR_DEFAULT_SURFACE) port.default_surface = value.surface;
    for (int i = 0; i < 4; ++i)
        port.default_value[i] = value.value[i];
}

// Value of a choice in a body: converts to int, or to an enum class whose members have the order
// of the names.
struct Choice {
    int index;
    operator int() const { return index; }
    template <class E>
    requires std::is_enum_v<E>
    operator E() const { return static_cast<E>(index); }
};

}  // namespace wrinkle::sdk
