/* A plugin as somebody built it when version 1 was new: with the frozen header, in plain C. Its
 * node sums a field's octaves, f(uv) + f(2 uv)/2 + f(4 uv)/4 ..., or takes the highest of them. */
#include <wrinkle/plugin.h>

enum { uv_port, amount_port, mode_port, octaves_port, inverted_port, field_port, sum_port };

static wr_value number(const wr_builder* b, double x) {
    return b->literal(b, WR_TYPE_float, &x);
}

static wr_value binary(const wr_builder* b, uint32_t op, wr_value x, wr_value y) {
    const wr_value args[2] = {x, y};
    return b->emit(b, op, WR_TYPE_poison, args, 2, 0);
}

static wr_region one_octave(const wr_builder* b) {
    static const uint32_t types[2] = {WR_TYPE_float, WR_TYPE_float};
    wr_value state[2], results[3], scale, height;
    const wr_value uv = b->input(b, uv_port);
    b->begin_region(b, WR_REGION_LOOP, "octaves", types, 2, state);
    scale = b->emit(b, WR_OP_exp2, WR_TYPE_poison, &state[0], 1, 0);
    height = b->field(b, field_port, binary(b, WR_OP_mul, uv, scale));
    height = binary(b, WR_OP_div, height, scale);
    results[0] = binary(b, WR_OP_lt, state[0], number(b, b->option(b, octaves_port)));
    results[1] = binary(b, WR_OP_add, state[0], number(b, 1));
    results[2] = binary(b, b->option(b, mode_port) == 0 ? WR_OP_add : WR_OP_max, state[1], height);
    return b->end_region(b, results, 3, 8);
}

static void build(const wr_builder* b) {
    wr_value start[2], end[2], sum;
    const wr_region octaves = one_octave(b);
    start[0] = start[1] = number(b, 0);
    b->apply(b, octaves, start, 2, end, 2);
    sum = binary(b, WR_OP_mul, end[1], b->input(b, amount_port));
    if (b->option(b, inverted_port)) sum = b->emit(b, WR_OP_neg, WR_TYPE_poison, &sum, 1, 0);
    b->name(b, sum, "octaves_sum");
    b->output(b, sum_port, sum);
}

static const char* const modes[2] = {"sum", "highest"};
#define PORT(Kind, Type, Name, Doc) \
    .size = sizeof(wr_port), .kind = (Kind), .type = (Type), .name = (Name), .doc = (Doc)
static const wr_port ports[] = {
    {PORT(WR_KIND_INPUT, WR_PORT_vec2, "uv", "Where to read it"),
     .default_kind = WR_DEFAULT_SURFACE, .default_surface = WR_SURFACE_uv0},
    {PORT(WR_KIND_INPUT, WR_PORT_float, "amount", "Factor of the whole"),
     .default_kind = WR_DEFAULT_CONSTANT, .default_value = {1}, .soft_max = 2, .hard_max = 8},
    {PORT(WR_KIND_CHOICE, 0, "mode", "What becomes of the octaves"), .choices = modes,
     .choice_count = 2},
    {PORT(WR_KIND_COUNT, 0, "octaves", "How many"), .default_value = {3}, .hard_min = 1,
     .hard_max = 8},
    {PORT(WR_KIND_FLAG, 0, "inverted", "Downwards")},
    {PORT(WR_KIND_FIELD, WR_PORT_height, "field", "What is summed, in length units"), .unit = "m",
     .default_kind = WR_DEFAULT_CONSTANT, .default_surface = WR_SURFACE_uv0},
    {PORT(WR_KIND_OUTPUT, WR_PORT_height, "sum", "In length units"), .unit = "m"},
};
static const wr_port* const port_list[] = {&ports[0], &ports[1], &ports[2], &ports[3],
                                           &ports[4], &ports[5], &ports[6]};
static const wr_rename rename = {sizeof(wr_rename), 2, "strength", "amount"};
static const wr_rename* const renames[] = {&rename};
static const wr_node node = {sizeof(wr_node),
                             2,
                             "v1_octaves",
                             "Octaves",
                             "Sums a field at growing scales.",
                             "test",
                             port_list,
                             7,
                             renames,
                             1,
                             build};
static const wr_node* const nodes[] = {&node};
static const wr_plugin plugin = {sizeof(wr_plugin), WR_ABI, "plugin_v1", "1.0", nodes, 1, 0};

const wr_plugin* wrinkle_plugin(void) {
    return &plugin;
}
