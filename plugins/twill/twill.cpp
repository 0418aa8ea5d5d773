// An example plugin with a field: an expression of the graph that the node reads at any uv. Here
// the field is the fibres of a thread, read along the direction of each thread.
#include "wrinkle/node.h"

using namespace wrinkle::sdk;

// Height of the threads along y, one in each unit of x: round across, over two threads and under
// two. `start`, in threads, shifts the pattern along y, so that threads along y and x alternate.
static Float thread(vec2 p, double start, Float width) {
    const Float lane = floor(p.x());
    const Float across = (2 * (p.x() - lane) - 1) / width;
    const Float wave = cos((p.y() - lane + start) * (3.14159265358979 / 2));
    return max(1 - across * across, 0) * (0.65 + 0.35 * wave);
}

struct Twill {
    vec2 uv;
    Field<Float> fibres;
    Float scale, width, amplitude;
};

static Node twill =
    node("twill", "Twill", "Denim: threads along u and v, each over two and under two.")
        .family("pattern")
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .field<Height>("fibres", surface::uv0,
                       "Relief on a thread that runs along v, made from uv0, in length units of "
                       "object space",
                       unit("m"))
        .in<Float>("scale", 24, "Threads per uv unit", slider(1, 64), unit("x"))
        .in<Float>("width", 0.9, "Width of a thread, in distances of two threads", slider(0.4, 1),
                   limits(0.3, 1), unit("x"))
        .in<Float>("amplitude", 0.01, "Height of a thread, in length units of object space",
                   slider(0, 0.05), unit("m"))
        .out<Height>("height", "In length units of object space, positive outward", unit("m"))
        .body([](Twill in) {
            const vec2 p = in.uv * in.scale;
            const Float warp = in.amplitude * thread(p, 0, in.width) + in.fibres(in.uv);
            const Float weft = in.amplitude * thread(p.yx(), 1, in.width) + in.fibres(in.uv.yx());
            // Threads finer than a pixel would alias, so the height fades to its mean.
            const Float pixel = named("pixel", detach(max(length(ddx(p)), length(ddy(p)))));
            return mix(max(warp, weft), 0.55 * in.amplitude, smoothstep(0.25, 0.75, pixel));
        });

WRINKLE_PLUGIN("twill", "1.0", twill)
