/* A plugin in C11: the header is valid C and needs no other header. */
#include "wrinkle/plugin.h"

static void build(const wr_builder* b) {
    const double two = 2;
    wr_value args[2];
    args[0] = b->input(b, 0);
    args[1] = b->literal(b, WR_TYPE_float, &two);
    b->output(b, 1, b->emit(b, WR_OP_mul, WR_TYPE_poison, args, 2, 0));
}

static const wr_port x = {.size = sizeof(wr_port),
                          .kind = WR_KIND_INPUT,
                          .type = WR_PORT_float,
                          .name = "x",
                          .doc = "The number",
                          .unit = "",
                          .default_kind = WR_DEFAULT_CONSTANT};
static const wr_port doubled = {.size = sizeof(wr_port),
                                .kind = WR_KIND_OUTPUT,
                                .type = WR_PORT_float,
                                .name = "doubled",
                                .doc = "Twice the number",
                                .unit = ""};
static const wr_port* const ports[] = {&x, &doubled};
static const wr_node twice = {.size = sizeof(wr_node),
                              .version = 1,
                              .id = "twice",
                              .title = "Twice",
                              .doc = "Doubles a number.",
                              .family = "math",
                              .ports = ports,
                              .port_count = 2,
                              .build = build};
static const wr_node* const nodes[] = {&twice};
static const wr_plugin plugin = {.size = sizeof(wr_plugin),
                                 .abi = WR_ABI,
                                 .id = "in_c",
                                 .version = "1.0",
                                 .nodes = nodes,
                                 .node_count = 1};

const wr_plugin* plugin_in_c(void);
const wr_plugin* plugin_in_c(void) {
    return &plugin;
}
