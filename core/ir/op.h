// Ops and types of the expression language, read from the one table in wrinkle/plugin.h.
// The semantics at the corners are written above that table.
#pragma once

#include <wrinkle/plugin.h>

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

const TypeInfo& info(Type type);
const OpInfo& info(Op op);  // an op that the table lacks has an empty name
const SurfaceInfo& info(SurfaceInput input);
constexpr int surface_input_count = 10;

inline bool is_opaque(Op op) {
    return info(op).flags & WR_FLAG_OPAQUE;
}
inline bool is_float_type(Type t) {
    return t >= Type::float_ && t <= Type::vec4_;
}
Type vector_of(int lanes);  // 1: float, 2-4: vecN

}  // namespace wrinkle
