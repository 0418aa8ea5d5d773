/* An example plugin in C11, without the SDK's C++ interface. Corrugated iron: a wave along u. */
#include "wrinkle/plugin.h"

enum { UV, RIDGES, AMPLITUDE, HEIGHT, PORT_COUNT };

static wr_value number(const wr_builder* b, double value) {
    return b->literal(b, WR_TYPE_float, &value);
}
static wr_value unary(const wr_builder* b, uint32_t op, wr_value x, uint32_t extra) {
    return b->emit(b, op, WR_TYPE_poison, &x, 1, extra);
}
static wr_value binary(const wr_builder* b, uint32_t op, wr_value x, wr_value y) {
    const wr_value args[] = {x, y};
    return b->emit(b, op, WR_TYPE_poison, args, 2, 0);
}

/* amplitude * cos(2 pi ridges u). Invalid operations return poison, so errors are not checked. */
static void build(const wr_builder* b) {
    const wr_value u = unary(b, WR_OP_swizzle, b->input(b, UV), WR_SWIZZLE(1, 0, 0, 0, 0));
    const wr_value turns = binary(b, WR_OP_mul, u, b->input(b, RIDGES));
    const wr_value angle = binary(b, WR_OP_mul, turns, number(b, 6.283185307179586));
    const wr_value wave = unary(b, WR_OP_cos, angle, 0);
    b->name(b, wave, "wave");
    b->output(b, HEIGHT, binary(b, WR_OP_mul, b->input(b, AMPLITUDE), wave));
}

static const wr_port uv = {.size = sizeof(wr_port),
                           .kind = WR_KIND_INPUT,
                           .type = WR_PORT_vec2,
                           .name = "uv",
                           .doc = "Where to read it",
                           .unit = "",
                           .default_kind = WR_DEFAULT_SURFACE,
                           .default_surface = WR_SURFACE_uv0};
static const wr_port ridges = {.size = sizeof(wr_port),
                               .kind = WR_KIND_INPUT,
                               .type = WR_PORT_float,
                               .name = "ridges",
                               .doc = "Ridges per uv unit",
                               .unit = "x",
                               .default_kind = WR_DEFAULT_CONSTANT,
                               .default_value = {12},
                               .soft_min = 0,
                               .soft_max = 64};
static const wr_port amplitude = {.size = sizeof(wr_port),
                                  .kind = WR_KIND_INPUT,
                                  .type = WR_PORT_float,
                                  .name = "amplitude",
                                  .doc =
                                      "Height of a ridge over the middle, in length units of "
                                      "object space",
                                  .unit = "m",
                                  .default_kind = WR_DEFAULT_CONSTANT,
                                  .default_value = {0.02},
                                  .soft_min = 0,
                                  .soft_max = 0.1};
static const wr_port height = {.size = sizeof(wr_port),
                               .kind = WR_KIND_OUTPUT,
                               .type = WR_PORT_height,
                               .name = "height",
                               .doc = "In length units of object space, positive outward",
                               .unit = "m"};
static const wr_port* const ports[PORT_COUNT] = {&uv, &ridges, &amplitude, &height};

static const wr_node corrugated = {.size = sizeof(wr_node),
                                   .version = 1,
                                   .id = "corrugated",
                                   .title = "Corrugated",
                                   .doc = "A wave along u, as corrugated iron has it.",
                                   .family = "pattern",
                                   .ports = ports,
                                   .port_count = PORT_COUNT,
                                   .build = build};
static const wr_node* const nodes[] = {&corrugated};

const wr_plugin* wrinkle_plugin(void) {
    static const wr_plugin plugin = {.size = sizeof(wr_plugin),
                                     .abi = WR_ABI,
                                     .id = "corrugated",
                                     .version = "1.0",
                                     .nodes = nodes,
                                     .node_count = 1};
    return &plugin;
}
