// Nodes on surface gradients. They compose in any order and are resolved once, at the end.
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

Node gradient_scale_node =
    node("gradient_scale", "Scale bump", "Makes a bump stronger or weaker; 0 is flat.")
        .family("gradient")
        .in<Gradient>("gradient", "The bump to scale")
        .in<Float>("amount", 1, "Factor of the slopes: 1 leaves it unchanged, negative inverts it",
                   slider(-2, 2), unit("x"))
        .out<Gradient>("gradient", "The scaled bump")
        .body([](Gradient g, Float amount) { return g * amount; });

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

Node resolve_node =
    node("resolve", "Resolve", "The normal that a bump gives. Do this once, at the end.")
        .family("gradient")
        .in<Gradient>("gradient", "All bumps, added up")
        .out<Normal>("normal", "Unit normal in object space")
        .body([](Gradient gradient) { return resolve(gradient); });

}  // namespace wrinkle::nodes
