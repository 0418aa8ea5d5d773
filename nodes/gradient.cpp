// Nodes on surface gradients. Gradients compose in any order and are resolved once, at the end.
#include <span>

#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

struct FromTangentNormal {
    vec3 normal;
    vec2 uv;
    Float strength;
    Scale scale;
    FrameMethod frame;
    vec3 direction, base;
};

static constinit Node gradient_list[] = {
    gradient_family("gradient_add", "Add bumps",
                    "Lays one bump over another; order does not matter.")
        .in<Gradient>("a", "One bump")
        .in<Gradient>("b", "The other bump")
        .out<Gradient>("gradient", "Both bumps together")
        .body([](Gradient a, Gradient b) { return a + b; }),

    gradient_family("gradient_subtract", "Subtract bumps",
                    "Carves one bump into another: what stands out of b is cut into a.")
        .in<Gradient>("a", "The bump to carve into")
        .in<Gradient>("b", "The bump that is cut in")
        .out<Gradient>("gradient", "a without b")
        .body([](Gradient a, Gradient b) { return a - b; }),

    gradient_family("gradient_scale", "Scale bump", "Makes a bump stronger or weaker; 0 is flat.")
        .in<Gradient>("gradient", "The bump to scale")
        .in<Float>("amount", 1, strength_doc, slider(-2, 2), unit("x"))
        .out<Gradient>("gradient", "The scaled bump")
        .body([](Gradient g, Float amount) { return g * amount; }),

    gradient_family("gradient_invert", "Invert bump",
                    "Turns hills into dents and dents into hills.")
        .in<Gradient>("gradient", "The bump to invert")
        .out<Gradient>("gradient", "The same slopes the other way round")
        .body([](Gradient g) { return -g; }),

    gradient_family(
        "gradient_mix", "Mix bumps",
        "Goes from one bump to another. The slope of the mask itself adds nothing; height_mix "
        "includes it.")
        .in<Gradient>("a", "The bump where the mask is 0")
        .in<Gradient>("b", "The bump where the mask is 1")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<Gradient>("gradient", "The mixed bump")
        .body([](Gradient a, Gradient b, Float mask) { return mix(a, b, mask); }),

    gradient_family(
        "gradient_over", "Bump over bump",
        "Covers one bump with another, as a decal or a deposit does: where b covers, a is gone. "
        "The slope of the coverage itself adds nothing; height_mix includes it.")
        .in<Gradient>("a", "The bump below")
        .in<Gradient>("b", "The bump on top")
        .in<Float>("amount", 1, "Factor of the slopes of b: 0 covers with a smooth surface",
                   slider(-2, 2), unit("x"))
        .in<Float>("coverage", 1, "How much b hides: 0 shows a, 1 shows b", slider(0, 1),
                   limits(0, 1))
        .out<Gradient>("gradient", "a under b")
        .body([](Gradient a, Gradient b, Float amount, Float coverage) {
            return mix(a, b * amount, coverage);
        }),

    gradient_family(
        "gradient_clamp_slope", "Limit slope",
        "Makes what is too steep less steep, in the same direction. Gentler slopes stay as they "
        "are, so the change from one to the other is a crease.")
        .in<Gradient>("gradient", "The bump to limit")
        .in<Float>("max_tilt", 60, "The steepest that remains, from the normal it is put on",
                   slider(0, 89), limits(0, 89.5), unit("deg"))
        .out<Gradient>("gradient", "The bump, nowhere steeper than that")
        .body([](Gradient g, Float max_tilt) {
            const Float limit = tan(radians(max_tilt)), slope = length(g.vector());
            return g * select(slope > limit, divide(limit, slope), 1);
        }),

    gradient_family(
        "gradient_tilt", "Tilt of bump",
        "How far a bump turns the normal: for masks by steepness and for looking at it.")
        .in<Gradient>("gradient", "The bump to measure")
        .out<Float>("tilt", "Angle between the normal with and without it, 0 to 90", unit("deg"))
        .out<Float>("slope", "Its tangent: rise per run", unit("x"))
        .body([](Gradient g) {
            const Float slope = length(g.vector());
            return std::tuple{degrees(atan(slope)), slope};
        }),

    gradient_family("normal_angle", "Angle of normals", "How far two normals are apart.")
        .in<Normal>("a", surface::normal, "One normal, any length")
        .in<Normal>("b", surface::normal, "The other normal, any length")
        .out<Float>("angle", "Between them, 0 to 180; 0 where one has no length", unit("deg"))
        .body([](vec3 a, vec3 b) { return degrees(atan(length(cross(a, b)), dot(a, b))); }),

    gradient_family(
        "gradient_from_height", "Bump from height",
        "The exact slope of a height along the surface, whatever the height is made of.")
        .in<Height>("height", 0, "In length units of object space, positive outward")
        .in<Normal>("base", surface::normal, base_doc)
        .out<Gradient>("gradient", "The bump of that height")
        .body([](Float height, vec3 base) { return gradient_from_height(height, Base(base)); }),

    gradient_family("gradient_from_volume", "Bump from volume gradient",
                    "The bump of a height that is defined in space, from its gradient there.")
        .in<vec3>("volume", 0,
                  "The height's change per length unit along x, y and z of object space")
        .in<Normal>("base", surface::normal, base_doc)
        .out<Gradient>("gradient", "The part of it along the surface")
        .body([](vec3 volume, vec3 base) { return gradient_from_volume(volume, Base(base)); }),

    gradient_family(
        "gradient_from_normal", "Bump from normal",
        "The bump that turns the surface's normal into the given one; one that points inward is "
        "mirrored outward.")
        .in<Normal>("normal", surface::normal, "Perturbed normal in object space, any length")
        .in<Normal>("base", surface::normal, base_doc)
        .out<Gradient>("gradient", "The bump that leads to it")
        .body([](vec3 normal, vec3 base) { return gradient_from_normal(normal, Base(base)); }),

    bump_in_frame(
        gradient_family(
            "gradient_from_tangent_normal", "Bump from tangent-space normal",
            "The bump of a tangent-space normal that was made, blended or read in some other way. "
            "Slopes are limited to 128.")
            .in<vec3>("normal", {0, 0, 1}, "In tangent space, z outward, any length; green is up")
            .in<vec2>("uv", surface::uv0, "The uv whose directions its x and y are")
            .in<Float>("strength", 1, strength_doc, slider(-2, 2), unit("x")),
        Scale::unit)
        .body([](FromTangentNormal in) { return bump_of_normal(in.normal, in); }),

    gradient_family("resolve", "Resolve", "The normal that a bump gives. Do this once, at the end.")
        .in<Gradient>("gradient", "All bumps, added up")
        .out<Normal>("normal", "Unit normal in object space")
        .body([](Gradient gradient) { return resolve(gradient); })};
constinit std::span<Node> gradient_nodes = gradient_list;

}  // namespace wrinkle::nodes
