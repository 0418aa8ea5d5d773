// Nodes that use features in which compilers may differ: fields, loops, functions, exceptions, and
// the standard library linked by each.
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "wrinkle/node.h"

using namespace wrinkle::sdk;

static Node weave =
    node("crossing_weave", "Weave", "Waves of several sizes, moved by a field.")
        .version(2)
        .renamed(2, "offset", "shift")
        .in<vec2>("uv", surface::uv0, "Where to read it")
        .field<Height>("shift", surface::uv0, "What moves it, in length units of object space")
        .count("octaves", 3, 1, 6, "How many sizes")
        .choice("wave", {"sine", "triangle"}, "The form of a wave")
        .flag("sharp", false, "With a power")
        .out<Height>("height", "In length units of object space")
        .out<Float>("mask", "0 to 1")
        .body([](vec2 uv, Field<Float> shift, int octaves, int wave, bool sharp) {
            std::vector<Float> sizes;
            for (int i = 0; i < octaves; ++i)
                sizes.push_back(Float(1 << i));
            const auto ripple = function("ripple", [&](Float x) {
                return wave == 0 ? sin(x) : abs(fract(x) - 0.5) * 4 - 1;
            });
            Float sum = 0;
            for (const Float& size : sizes)
                sum = sum + ripple(uv.x() * size + shift(uv / size)) * ripple(uv.y() * size) / size;
            const Float mask = saturate(sum * 0.5 + 0.5);
            return std::tuple{Float(sharp ? pow(mask, Float(3)) : sum) * 0.01, mask};
        });

static Node march =
    node("crossing_march", "March", "Follows a slope for a while.")
        .in<vec3>("start", surface::position, "Where it begins, in length units of object space")
        .in<Float>("stop", 0.5, "How far it goes, in length units of object space", slider(0, 1))
        .out<Float>("way", "How far it came, in length units of object space")
        .body([](vec3 start, Float stop) {
            const auto [way, height] =
                loop(16, std::tuple{Float(0), Float(1)}, [&](Float far, Float high) {
                    const vec3 here = start + far;
                    return std::tuple{high > 0 && far < stop, far + 0.125,
                                      dot(sin(here * 5), vec3(0.3, 0.5, 0.2))};
                });
            return way + height * 0.001;
        });

static Node bump =
    node("crossing_bump", "Bump", "A picture's normals over a plain slope.")
        .in<Image>("image", "Normals", encoding("normal_gl"))
        .in<Gradient>("below", "The bump below")
        .in<Float>("amount", 0.1 + 0.2, "Factor of the slopes", limits(-3, 3), unit("x"))
        .out<Gradient>("gradient", "Both")
        .body([](Image image, Gradient below, Float amount) {
            const vec3 texel = image.sample(surface::uv0).rgb() * 2 - 1;
            const Gradient above(Derivative(-texel.xy() / max(texel.z(), Float(0.01)),
                                            frame(surface::uv0, Scale::unit)));
            return mix(below, above * amount, Float(1) / 3);
        });

static Node thrower =
    node("crossing_throw", "Throw", "Throws what its choice says.")
        .choice("what", {"standard", "number", "far"}, "What is thrown")
        .out<Float>("value", "Never given")
        .body([](int what) -> Float {
            if (what == 0)
                throw std::runtime_error("thrown " + std::to_string(what + 41) + " times");
            if (what == 1) throw 7;
            return Float(static_cast<double>(std::vector<int>{1, 2}.at(static_cast<size_t>(what))));
        });

WRINKLE_PLUGIN("crossing", "1.0", weave, march, bump, thrower)
