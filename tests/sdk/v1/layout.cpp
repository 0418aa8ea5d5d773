// Compiled once for each header; LAYOUT is the name of the function.
#include "sdk/v1/layout.h"

#include <wrinkle/plugin.h>

#include <typeinfo>

namespace wrinkle::testing {
namespace {

// clang-format off
#define MEMBER(S, m) \
    {#S, #m, typeid(decltype(S::m)).name(), offsetof(S, m), sizeof(S::m), alignof(decltype(S::m))}
#define CONSTANT(name) {#name, name}

std::vector<Member> members() {
    return {
        MEMBER(wr_builder, size), MEMBER(wr_builder, host), MEMBER(wr_builder, input),
        MEMBER(wr_builder, image), MEMBER(wr_builder, option), MEMBER(wr_builder, field),
        MEMBER(wr_builder, literal), MEMBER(wr_builder, surface), MEMBER(wr_builder, emit),
        MEMBER(wr_builder, sample), MEMBER(wr_builder, begin_region),
        MEMBER(wr_builder, end_region), MEMBER(wr_builder, apply), MEMBER(wr_builder, output),
        MEMBER(wr_builder, error), MEMBER(wr_builder, get_extension), MEMBER(wr_builder, name),
        MEMBER(wr_port, size), MEMBER(wr_port, kind), MEMBER(wr_port, type), MEMBER(wr_port, name),
        MEMBER(wr_port, doc), MEMBER(wr_port, unit), MEMBER(wr_port, default_kind),
        MEMBER(wr_port, default_surface), MEMBER(wr_port, default_value),
        MEMBER(wr_port, soft_min), MEMBER(wr_port, soft_max), MEMBER(wr_port, hard_min),
        MEMBER(wr_port, hard_max), MEMBER(wr_port, choices), MEMBER(wr_port, choice_count),
        MEMBER(wr_port, encoding),
        MEMBER(wr_rename, size), MEMBER(wr_rename, version), MEMBER(wr_rename, old_name),
        MEMBER(wr_rename, new_name),
        MEMBER(wr_node, size), MEMBER(wr_node, version), MEMBER(wr_node, id),
        MEMBER(wr_node, title), MEMBER(wr_node, doc), MEMBER(wr_node, family),
        MEMBER(wr_node, ports), MEMBER(wr_node, port_count), MEMBER(wr_node, renames),
        MEMBER(wr_node, rename_count), MEMBER(wr_node, build),
        MEMBER(wr_plugin, size), MEMBER(wr_plugin, abi), MEMBER(wr_plugin, id),
        MEMBER(wr_plugin, version), MEMBER(wr_plugin, nodes), MEMBER(wr_plugin, node_count),
        MEMBER(wr_plugin, get_extension),
    };
}

std::vector<Constant> constants() {
    return {
        CONSTANT(WR_ABI), CONSTANT(WR_SURFACE_FRONT_NORMAL), CONSTANT(WR_FLAG_COMMUTATIVE),
        CONSTANT(WR_FLAG_OPAQUE), CONSTANT(WR_FLAG_IMPLICIT), CONSTANT(WR_FLAG_ZERO_DERIVATIVE),
        CONSTANT(WR_POISON), CONSTANT(WR_REGION_FUNCTION), CONSTANT(WR_REGION_LOOP),
        CONSTANT(WR_KIND_INPUT), CONSTANT(WR_KIND_OUTPUT), CONSTANT(WR_KIND_CHOICE),
        CONSTANT(WR_KIND_COUNT), CONSTANT(WR_KIND_FLAG), CONSTANT(WR_KIND_FIELD),
        CONSTANT(WR_DEFAULT_NONE), CONSTANT(WR_DEFAULT_CONSTANT), CONSTANT(WR_DEFAULT_SURFACE),
        {"WR_FRAME", WR_FRAME(3, 1)}, {"WR_SWIZZLE", WR_SWIZZLE(4, 3, 2, 1, 0)},
    };
}

std::vector<std::string> rows() {
    return {
#define X(...) "WR_TYPES: " #__VA_ARGS__,
        WR_TYPES(X)
#undef X
#define X(...) "WR_PORT_TYPES: " #__VA_ARGS__,
        WR_PORT_TYPES(X)
#undef X
#define X(...) "WR_SURFACE_INPUTS: " #__VA_ARGS__,
        WR_SURFACE_INPUTS(X)
#undef X
#define X(...) "WR_OPS: " #__VA_ARGS__,
        WR_OPS(X)
#undef X
#define X(...) "WR_FRAME_METHODS: " #__VA_ARGS__,
        WR_FRAME_METHODS(X)
#undef X
#define X(...) "WR_SCALES: " #__VA_ARGS__,
        WR_SCALES(X)
#undef X
    };
}
// clang-format on

}  // namespace

Layout LAYOUT() {
    return {members(),
            {{"wr_builder", sizeof(wr_builder)},
             {"wr_port", sizeof(wr_port)},
             {"wr_rename", sizeof(wr_rename)},
             {"wr_node", sizeof(wr_node)},
             {"wr_plugin", sizeof(wr_plugin)}},
            rows(),
            constants()};
}

}  // namespace wrinkle::testing
