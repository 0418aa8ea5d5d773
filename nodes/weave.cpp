// Plain weave as a relief.
#include <span>

#include "nodes/constants.h"
#include "nodes/footprint.h"
#include "nodes/relief.h"

namespace wrinkle::nodes {
using namespace sdk;

// Height of the threads along v, one in each unit of u: round across, highest in every second cell,
// where the thread is above the other one, and 0.35 of that where it is below.
static auto thread_function() {
    return function("thread(p, side, width)", [](vec2 p, Float side, Float width) {
        const Float lane = floor(p.x());
        const Float across = (2 * (p.x() - lane) - 1) / width;
        const Float above = side * cos(mod(p.y() - 0.5 + lane, 2.0) * pi());
        return max(1 - across * across, 0) * (0.675 + 0.325 * above);
    });
}

static constinit Node weave_list[] = {
    relief(pattern_on_uv("weave", "Weave",
                         "Plain cloth: round threads along u and v, each in turn above and below.",
                         "scale", 8, "Threads per uv unit")
               .in<Float>("width", 0.9, "Of a thread, in the distance of two threads",
                          slider(0.4, 1), limits(0.3, 1)),
           0.02, "1 where a thread is on top, 0 between threads")
        .body([](vec2 uv, Float scale, Float width, Float amplitude) {
            const auto thread = thread_function();
            const vec2 p = uv * scale;
            const Float value = max(thread(p, 1, width), thread(p.yx(), -1, width));
            const Float mean = width * (0.917 - 0.271 * width);  // fitted to the mean of `value`
            return relief_of(mix(mean_height(mean), value, fade(footprint(p))), amplitude);
        })};
constinit std::span<Node> weave_nodes = weave_list;

}  // namespace wrinkle::nodes
