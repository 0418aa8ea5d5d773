// Ops and types of the expression language, from the table in wrinkle/plugin.h. Edge cases of the
// semantics are documented above that table.
#pragma once

#include <wrinkle/plugin.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace wrinkle {

#define X(name, number, glsl, lanes) name##_ = number,
enum class Type : uint8_t { WR_TYPES(X) };
#undef X

#define X(name, number, arity, rule, glsl, precedence, flags) name##_ = number,
enum class Op : uint16_t { WR_OPS(X) };
#undef X

#define X(name, number, type, doc) name##_ = number,
enum class SurfaceInput : uint8_t { WR_SURFACE_INPUTS(X) };
#undef X

enum class Rule : uint8_t { leaf, same, broadcast, floats, compare, logic, bits, special };

struct TypeInfo {
    std::string_view name;  // also the GLSL spelling where there is one
    uint8_t lanes;          // 0 for opaque types
};
struct OpInfo {
    std::string_view name;
    int8_t arity;  // -1: variadic
    Rule rule;
    std::string_view glsl;
    uint8_t precedence;  // 0: call syntax
    uint8_t flags;       // WR_FLAG_*
};
struct SurfaceInfo {
    std::string_view name;
    Type type;
    std::string_view doc;
};

// The tables behind info(); every pass reads them for every instruction.
namespace tables {

inline constexpr TypeInfo types[] = {
#define X(name, number, glsl, lanes) {#name, lanes},
    WR_TYPES(X)
#undef X
};

inline constexpr SurfaceInfo surface_inputs[] = {
#define X(name, number, type, doc) {#name, Type::type##_, doc},
    WR_SURFACE_INPUTS(X)
#undef X
};

inline constexpr size_t op_count = 256;
inline constexpr auto ops = [] {
    std::array<OpInfo, op_count + 1> table{};  // the last entry: unknown ops
#define X(name, number, arity, rule, glsl, precedence, flags) \
    table[number] = {#name, arity, Rule::rule, glsl, precedence, flags};
    WR_OPS(X)
#undef X
    return table;
}();

}  // namespace tables

constexpr const TypeInfo& info(Type type) {
    return tables::types[static_cast<size_t>(type)];
}
// An op that the table lacks has an empty name.
constexpr const OpInfo& info(Op op) {
    const auto number = static_cast<size_t>(op);
    return tables::ops[number < tables::op_count ? number : tables::op_count];
}
constexpr const SurfaceInfo& info(SurfaceInput input) {
    return tables::surface_inputs[static_cast<size_t>(input)];
}
constexpr int surface_input_count = 10;

constexpr bool is_opaque(Op op) {
    return info(op).flags & WR_FLAG_OPAQUE;
}
// Returns true if the op reads texels.
constexpr bool is_sample(Op op) {
    return op == Op::sample_ || op == Op::sample_lod_ || op == Op::sample_grad_;
}
// Returns true if `extra` is an index into Module::resources.
constexpr bool reads_image(Op op) {
    return is_sample(op) || op == Op::image_size_;
}
// Returns true if the op creates a gradient; `extra` is its base.
constexpr bool is_gradient_source(Op op) {
    return (op >= Op::gradient_from_derivative_ && op <= Op::gradient_from_normal_) ||
           op == Op::gradient_from_outward_normal_;
}

// `extra` of an input: which surface input, and the value itself or its differential to the next
// pixel. In shaders the differential of `position` is taken from a camera-relative position in
// object axes, for precision.
enum class Variant : uint8_t { value, dx, dy };
constexpr uint32_t input_extra(SurfaceInput input, Variant variant) {
    return static_cast<uint32_t>(input) | static_cast<uint32_t>(variant) << 8;
}
constexpr SurfaceInput input_of(uint32_t extra) {
    return static_cast<SurfaceInput>(extra & 0xFF);
}
constexpr Variant variant_of(uint32_t extra) {
    return static_cast<Variant>(extra >> 8);
}

// The components of a swizzle by its `extra`, WR_SWIZZLE.
constexpr int swizzle_count(uint32_t extra) {
    return static_cast<int>(extra & 0xF);
}
constexpr int swizzle_component(uint32_t extra, int lane) {
    return static_cast<int>(extra >> (4 + 4 * lane) & 0xF);
}
// The bits of a swizzle's `extra` by which component `lane` is `component` of the operand.
constexpr uint32_t swizzle_lane(int component, int lane) {
    return static_cast<uint32_t>(component) << (4 + 4 * lane);
}

constexpr bool is_float_type(Type t) {
    return t >= Type::float_ && t <= Type::vec4_;
}
constexpr bool is_whole_type(Type t) {
    return t >= Type::int_ && t <= Type::bool_;
}
constexpr Type vector_of(int lanes) {  // 1: float, 2-4: vecN
    return static_cast<Type>(lanes);
}

}  // namespace wrinkle
