// Several layers of bumps in one node, from bottom to top.
#include <span>

#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class LayerMode { add, subtract, over };

struct CompositorLayer {
    Gradient gradient;
    LayerMode mode;
    Float amount, mask;
};

static Gradient laid(Gradient below, const CompositorLayer& layer) {
    const Gradient bump = layer.gradient * layer.amount;
    if (layer.mode == LayerMode::over) return mix(below, bump, layer.mask);
    if (layer.mode == LayerMode::subtract) return below - bump * layer.mask;
    return below + bump * layer.mask;
}

struct Compositor {
    Gradient base;
    int layers;
    Gradient gradient1;
    LayerMode mode1;
    Float amount1, mask1;
    Gradient gradient2;
    LayerMode mode2;
    Float amount2, mask2;
    Gradient gradient3;
    LayerMode mode3;
    Float amount3, mask3;
    Gradient gradient4;
    LayerMode mode4;
    Float amount4, mask4;
};

#define LAYER(n)                                                                                  \
    .in<Gradient>("gradient" #n, "The bump of layer " #n)                                         \
        .choice("mode" #n, {"add", "subtract", "over"},                                           \
                "Layer " #n " is added, cut in, or hides what is below")                          \
        .in<Float>("amount" #n, 1, "Factor of the slopes of layer " #n, slider(-2, 2), unit("x")) \
        .in<Float>("mask" #n, 1, "Where layer " #n " is: 0 nowhere, 1 fully", slider(0, 1),       \
                   limits(0, 1))

static constinit Node compositor_list[] = {
    node("gradient_compositor", "Compositor",
         "Lays up to four bumps over a base. Layers that are added or subtracted may change "
         "places; one that is `over` hides what comes before it.")
        .family("gradient")
        .in<Gradient>("base", "The bump at the bottom")
        .count("layers", 2, 1, 4, "How many of the layers are used")
    // clang-format off
        LAYER(1) LAYER(2) LAYER(3) LAYER(4)
        // clang-format on
        .out<Gradient>("gradient", "All layers together")
        .body([](Compositor in) {
            const CompositorLayer layers[] = {{in.gradient1, in.mode1, in.amount1, in.mask1},
                                              {in.gradient2, in.mode2, in.amount2, in.mask2},
                                              {in.gradient3, in.mode3, in.amount3, in.mask3},
                                              {in.gradient4, in.mode4, in.amount4, in.mask4}};
            Gradient sum = in.base;
            for (int i = 0; i < in.layers; ++i)
                sum = laid(sum, layers[i]);
            return sum;
        })};
constinit std::span<Node> compositor_nodes = compositor_list;

#undef LAYER

}  // namespace wrinkle::nodes
