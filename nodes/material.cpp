// Materials on a wire: a channel for each standard output, and layers of materials.
#include <span>

#include "base/standard_outputs.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr uint32_t port_type(const StandardOutput& output) {
    const std::string_view type = channel_type(output);
#define X(name, number, value) \
    if (type == #name) return number;
    WR_PORT_TYPES(X)
#undef X
    return 0;
}

static constexpr wr_port channel_port(const StandardOutput& output, uint32_t kind) {
    wr_port port = make_port(kind, port_type(output), output.name.data(), output.doc.data());
    port.unit = output.unit.data();
    if (kind == WR_KIND_OUTPUT) return port;
    port.default_kind = WR_DEFAULT_ABSENT;
    for (size_t i = 0; i < output.value.size(); ++i)
        port.default_value[i] = output.value[i];
    if (port.type == WR_PORT_float || port.type == WR_PORT_color) {
        port.soft_min = output.low;
        port.soft_max = output.slider_high;
    }
    return port;
}

// A node with one port of type material and a port for each channel.
static constexpr Description channels_node(const char* id, const char* title, const char* doc,
                                           wr_port first, uint32_t kind) {
    Description d;
    d.node.size = sizeof(wr_node);
    d.node.version = 1;
    d.node.id = id;
    d.node.title = title;
    d.node.doc = doc;
    d.node.family = "material";
    d.ports[d.node.port_count++] = first;
    for (const StandardOutput& output : standard_output_table)
        d.ports[d.node.port_count++] = channel_port(output, kind);
    return d;
}

// The index of the port of a channel; port 0 is the material.
static uint32_t port_of(const StandardOutput& output) {
    return static_cast<uint32_t>(&output - standard_output_table.data()) + 1;
}

static constexpr Description collected = [] {
    Description d = channels_node(
        "material", "Material", "A material of the channels that are connected or set here.",
        make_port(WR_KIND_INPUT, WR_PORT_material, "base",
                  "The material to change; without it there are no other channels"),
        WR_KIND_INPUT);
    d.ports[d.node.port_count++] =
        make_port(WR_KIND_OUTPUT, WR_PORT_material, "material", "The material");
    return d;
}();

static void collect(const wr_builder* b) {
    const UseBuilder use(b);
    Material material(Raw{b->input(b, 0)});
    for (const StandardOutput& output : standard_output_table)
        material =
            material.with(output.name.data(), port_type(output), Raw{b->input(b, port_of(output))});
    b->output(b, collected.node.port_count - 1, material.id);
}

static constexpr Description split_channels = channels_node(
    "material_split", "Split material",
    "The channels of a material; one that it does not have is its default.",
    make_port(WR_KIND_INPUT, WR_PORT_material, "material", "The material"), WR_KIND_OUTPUT);

static void split(const wr_builder* b) {
    const UseBuilder use(b);
    const Material material(Raw{b->input(b, 0)});
    for (const StandardOutput& output : standard_output_table)
        b->output(b, port_of(output), material.channel(output.name.data(), port_type(output)).id);
}

static constexpr auto material_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("material");
}

static constinit Node material_list[] = {
    Node(collected, collect),
    Node(split_channels, split),

    material_family(
        "material_mix", "Mix materials",
        "Goes from one material to another: every channel is mixed, bumps as gradients.")
        .in<Material>("a", "The material where the mask is 0")
        .in<Material>("b", "The material where the mask is 1")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<Material>("material", "(1 - mask) a + mask b")
        .body([](Material a, Material b, Float mask) { return mix(a, b, mask); }),

    material_family("material_over", "Material over",
                    "Covers a material with another one by the other one's opacity.")
        .in<Material>("base", "The material below")
        .in<Material>("top", "The material above")
        .in<Float>("amount", 1, "Factor of the opacity of the material above", slider(0, 1))
        .out<Material>("material", "The material above where it is opaque, else that below")
        .body([](Material base, Material top, Float amount) {
            const Float above = saturate(amount * top.channel<Float>("opacity"));
            const Float below = base.channel<Float>("opacity");
            const Float both = named("opacity", above + (1 - above) * below);
            return mix(base, top, divide(above, both)).with<Float>("opacity", both);
        }),

    // Height blend (A. Mishkinis, "Advanced terrain texture splatting", 2013).
    material_family("material_layer", "Layer materials",
                    "Lets the higher one of two materials cover the other, by their heights.")
        .in<Material>("base", "The material where the amount is 0")
        .in<Material>("top", "The material where the amount is 1")
        .in<Float>("amount", 0.5, "0 is the base, 1 is the top", slider(0, 1), limits(0, 1))
        .in<Height>("range", 0.02,
                    "Difference of heights that an amount of 1 outweighs, in length units",
                    slider(0.001, 0.1), limits(0.0001, 1e6))
        .in<Float>("contrast", 0.2, "Width of the transition: 0 hard, 1 soft", slider(0.01, 1),
                   limits(1e-4, 1))
        .out<Material>("material", "The layered material")
        .out<Float>("mask", "0 is the base, 1 is the top")
        .body([](Material base, Material top, Float amount, Float range, Float contrast) {
            const Float heights = top.channel<Height>("height") - base.channel<Height>("height");
            const Float lead = named("lead", heights / range + (2 * amount - 1));
            const Float of_base = named("of_base", max(contrast - max(lead, 0), 0));
            const Float of_top = named("of_top", max(contrast + min(lead, 0), 0));
            const Float mask = named("mask", of_top / (of_base + of_top));
            return std::tuple(mix(base, top, mask), mask);
        }),
};

constinit std::span<Node> material_nodes = material_list;

}  // namespace wrinkle::nodes
