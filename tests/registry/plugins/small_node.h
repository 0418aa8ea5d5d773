/* A node that passes a float through, as in a plugin in plain C. */
#ifndef SMALL_NODE_H
#define SMALL_NODE_H
#include <wrinkle/plugin.h>

static void build(const wr_builder* b) {
    b->output(b, 1, b->input(b, 0));
}

static const wr_port in_port = {.size = sizeof(wr_port),
                                .kind = WR_KIND_INPUT,
                                .type = WR_PORT_float,
                                .name = "value",
                                .doc = "What is passed",
                                .default_kind = WR_DEFAULT_CONSTANT};
static const wr_port out_port = {.size = sizeof(wr_port),
                                 .kind = WR_KIND_OUTPUT,
                                 .type = WR_PORT_float,
                                 .name = "value",
                                 .doc = "The same"};
static const wr_port* const ports[] = {&in_port, &out_port};

#define SMALL_PLUGIN(plugin_id, node_id, abi_number)            \
    static const wr_node small = {.size = sizeof(wr_node),      \
                                  .version = 1,                 \
                                  .id = node_id,                \
                                  .title = "Small",             \
                                  .doc = "Passes a float.",     \
                                  .family = "test",             \
                                  .ports = ports,               \
                                  .port_count = 2,              \
                                  .build = build};              \
    static const wr_node* const nodes[] = {&small};             \
    static const wr_plugin plugin = {.size = sizeof(wr_plugin), \
                                     .abi = abi_number,         \
                                     .id = plugin_id,           \
                                     .version = "1.2",          \
                                     .nodes = nodes,            \
                                     .node_count = 1};          \
    WR_EXPORT const wr_plugin* wrinkle_plugin(void) {           \
        return &plugin;                                         \
    }
#endif
