#include "ir/op.h"

#include <array>

namespace wrinkle {
namespace {

constexpr TypeInfo types[] = {
#define X(name, number, glsl, lanes) {#name, lanes},
    WR_TYPES(X)
#undef X
};

constexpr SurfaceInfo surface_inputs[] = {
#define X(name, number, type, doc) {#name, Type::type##_, doc},
    WR_SURFACE_INPUTS(X)
#undef X
};

constexpr size_t op_count = 256;

constexpr std::array<OpInfo, op_count> op_table() {
    std::array<OpInfo, op_count> table{};
#define X(name, number, arity, rule, glsl, precedence, flags) \
    table[number] = {#name, arity, Rule::rule, glsl, precedence, flags};
    WR_OPS(X)
#undef X
    return table;
}
constexpr std::array<OpInfo, op_count> ops = op_table();

}  // namespace

const TypeInfo& info(Type type) {
    return types[static_cast<size_t>(type)];
}

const OpInfo& info(Op op) {
    static constexpr OpInfo unknown{};
    const auto number = static_cast<size_t>(op);
    return number < op_count ? ops[number] : unknown;
}

const SurfaceInfo& info(SurfaceInput input) {
    return surface_inputs[static_cast<size_t>(input)];
}

Type vector_of(int lanes) {
    return static_cast<Type>(lanes);
}

}  // namespace wrinkle
