// Nodes on surface gradients. Gradients compose in any order and are resolved once, at the end.
#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

Node gradient_add_node =
    node("gradient_add", "Add bumps", "Lays one bump over another; order does not matter.")
        .family("gradient")
        .in<Gradient>("a", "One bump")
        .in<Gradient>("b", "The other bump")
        .out<Gradient>("gradient", "Both bumps together")
        .body([](Gradient a, Gradient b) { return a + b; });

Node gradient_subtract_node =
    node("gradient_subtract", "Subtract bumps",
         "Carves one bump into another: what stands out of b is cut into a.")
        .family("gradient")
        .in<Gradient>("a", "The bump to carve into")
        .in<Gradient>("b", "The bump that is cut in")
        .out<Gradient>("gradient", "a without b")
        .body([](Gradient a, Gradient b) { return a - b; });

Node gradient_scale_node =
    node("gradient_scale", "Scale bump", "Makes a bump stronger or weaker; 0 is flat.")
        .family("gradient")
        .in<Gradient>("gradient", "The bump to scale")
        .in<Float>("amount", 1, "Factor of the slopes: 1 leaves it unchanged, negative inverts it",
                   slider(-2, 2), unit("x"))
        .out<Gradient>("gradient", "The scaled bump")
        .body([](Gradient g, Float amount) { return g * amount; });

Node gradient_invert_node =
    node("gradient_invert", "Invert bump", "Turns hills into dents and dents into hills.")
        .family("gradient")
        .in<Gradient>("gradient", "The bump to invert")
        .out<Gradient>("gradient", "The same slopes the other way round")
        .body([](Gradient g) { return -g; });

Node gradient_mix_node =
    node("gradient_mix", "Mix bumps",
         "Goes from one bump to another. The slope of the mask itself adds nothing; height_mix "
         "includes it.")
        .family("gradient")
        .in<Gradient>("a", "The bump where the mask is 0")
        .in<Gradient>("b", "The bump where the mask is 1")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<Gradient>("gradient", "The mixed bump")
        .body([](Gradient a, Gradient b, Float mask) { return mix(a, b, mask); });

Node gradient_over_node =
    node("gradient_over", "Bump over bump",
         "Covers one bump with another, as a decal or a deposit does: where b covers, a is gone. "
         "The slope of the coverage itself adds nothing; height_mix includes it.")
        .family("gradient")
        .in<Gradient>("a", "The bump below")
        .in<Gradient>("b", "The bump on top")
        .in<Float>("amount", 1, "Factor of the slopes of b: 0 covers with a smooth surface",
                   slider(-2, 2), unit("x"))
        .in<Float>("coverage", 1, "How much b hides: 0 shows a, 1 shows b", slider(0, 1),
                   limits(0, 1))
        .out<Gradient>("gradient", "a under b")
        .body([](Gradient a, Gradient b, Float amount, Float coverage) {
            return mix(a, b * amount, coverage);
        });

Node gradient_clamp_slope_node =
    node("gradient_clamp_slope", "Limit slope",
         "Makes what is too steep less steep, in the same direction. Gentler slopes stay as they "
         "are, so the change from one to the other is a crease.")
        .family("gradient")
        .in<Gradient>("gradient", "The bump to limit")
        .in<Float>("max_tilt", 60, "The steepest that remains, from the normal it is put on",
                   slider(0, 89), limits(0, 89.5), unit("deg"))
        .out<Gradient>("gradient", "The bump, nowhere steeper than that")
        .body([](Gradient g, Float max_tilt) {
            const Float limit = tan(radians(max_tilt)), slope = length(g.vector());
            return g * select(slope > limit, divide(limit, slope), 1);
        });

Node gradient_tilt_node =
    node("gradient_tilt", "Tilt of bump",
         "How far a bump turns the normal: for masks by steepness and for looking at it.")
        .family("gradient")
        .in<Gradient>("gradient", "The bump to measure")
        .out<Float>("tilt", "Angle between the normal with and without it, 0 to 90", unit("deg"))
        .out<Float>("slope", "Its tangent: rise per run", unit("x"))
        .body([](Gradient g) {
            const Float slope = length(g.vector());
            return std::tuple{degrees(atan(slope)), slope};
        });

Node normal_angle_node =
    node("normal_angle", "Angle of normals", "How far two normals are apart.")
        .family("gradient")
        .in<Normal>("a", surface::normal, "One normal, any length")
        .in<Normal>("b", surface::normal, "The other normal, any length")
        .out<Float>("angle", "Between them, 0 to 180; 0 where one has no length", unit("deg"))
        .body([](vec3 a, vec3 b) { return degrees(atan(length(cross(a, b)), dot(a, b))); });

Node gradient_from_height_node =
    node("gradient_from_height", "Bump from height",
         "The exact slope of a height along the surface, whatever the height is made of.")
        .family("gradient")
        .in<Height>("height", 0, "In length units of object space, positive outward")
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Gradient>("gradient", "The bump of that height")
        .body([](Float height, vec3 base) { return gradient_from_height(height, Base(base)); });

Node gradient_from_volume_node =
    node("gradient_from_volume", "Bump from volume gradient",
         "The bump of a height that is defined in space, from its gradient there.")
        .family("gradient")
        .in<vec3>("volume", 0,
                  "The height's change per length unit along x, y and z of object space")
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Gradient>("gradient", "The part of it along the surface")
        .body([](vec3 volume, vec3 base) { return gradient_from_volume(volume, Base(base)); });

Node gradient_from_normal_node =
    node("gradient_from_normal", "Bump from normal",
         "The bump that turns the surface's normal into the given one; one that points inward is "
         "mirrored outward.")
        .family("gradient")
        .in<Normal>("normal", surface::normal, "Perturbed normal in object space, any length")
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Gradient>("gradient", "The bump that leads to it")
        .body([](vec3 normal, vec3 base) { return gradient_from_normal(normal, Base(base)); });

struct FromTangentNormal {
    vec3 normal;
    vec2 uv;
    Float strength;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

Node gradient_from_tangent_normal_node =
    node("gradient_from_tangent_normal", "Bump from tangent-space normal",
         "The bump of a tangent-space normal that was made, blended or read in some other way. "
         "Slopes are limited to 128.")
        .family("gradient")
        .in<vec3>("normal", {0, 0, 1}, "In tangent space, z outward, any length; green is up")
        .in<vec2>("uv", surface::uv0, "The uv whose directions its x and y are")
        .in<Float>("strength", 1,
                   "Factor of the slopes: 1 leaves it unchanged, negative inverts it",
                   slider(-2, 2), unit("x"))
        .choice("scale", SCALES, SCALE_DOC, static_cast<int>(Scale::unit))
        .choice("frame", FRAME_METHODS, FRAME_DOC)
        .in<vec3>("direction", {0, 1, 0}, DIRECTION_DOC)
        .in<Normal>("base", surface::normal, BASE_DOC)
        .out<Gradient>("gradient", "The bump")
        .out<Derivative>("derivative", "The slopes with their frame")
        .body([](FromTangentNormal in) {
            const Derivative d = normal_derivative(in.normal, in.strength,
                                                   frame(in.uv, in.frame, in.scale, in.direction));
            return std::tuple{Gradient(d, Base(in.base)), d};
        });

Node resolve_node =
    node("resolve", "Resolve", "The normal that a bump gives. Do this once, at the end.")
        .family("gradient")
        .in<Gradient>("gradient", "All bumps, added up")
        .out<Normal>("normal", "Unit normal in object space")
        .body([](Gradient gradient) { return resolve(gradient); });

}  // namespace wrinkle::nodes
