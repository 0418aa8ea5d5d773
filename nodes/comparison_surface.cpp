// Common operations on a surface normal, for comparison. The documentation of each node states its
// error.
#include <span>

#include "nodes/blend.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

enum class BumpBlend { udn, whiteout, rnm, linear, partial_derivative };

static vec3 blended(vec3 a, vec3 b, BumpBlend blend) {
    switch (blend) {
        case BumpBlend::udn:
            return udn_blend(a, b);
        case BumpBlend::whiteout:
            return whiteout_blend(a, b);
        case BumpBlend::rnm:
            return rnm_blend(a, b);
        case BumpBlend::linear:
            return linear_blend(a, b);
        case BumpBlend::partial_derivative:
            break;
    }
    return partial_derivative_blend(a, b);
}

enum class PixelAxes { lengths, unit };

static constinit Node comparison_surface_list[] = {
    comparison_family(
        "compare_perlin", "Wrong: unprojected gradient",
        "Subtracts the gradient of a volume from the normal whole. Wrong: the part along the "
        "normal tilts it too, up to facing inward; gradient_from_volume takes that part out.")
        .in<vec3>("volume", 0,
                  "The height's change per length unit along x, y and z of object space")
        .in<Normal>("normal", surface::normal, "The normal to bump, object space")
        .out<Normal>("bumped", "Unit normal in object space")
        .body([](vec3 volume, vec3 normal) { return normalize(normal - volume); }),

    comparison_family(
        "compare_weighted_normals", "Wrong: average of normals",
        "The weighted average of bumped normals. Wrong: a flat layer pulls the others back to "
        "the surface; in a sum of gradients it adds nothing.")
        .in<Normal>("a", surface::normal, "One bumped normal, object space")
        .in<Normal>("b", surface::normal, "The other bumped normal, object space")
        .in<Float>("weight_a", 1, "Weight of the first", slider(0, 1))
        .in<Float>("weight_b", 1, "Weight of the second", slider(0, 1))
        .out<Normal>("normal", "Unit normal in object space")
        .body([](vec3 a, vec3 b, Float weight_a, Float weight_b) {
            return normalize(a * weight_a + b * weight_b);
        }),

    comparison_family(
        "compare_blender_strength", "Wrong: strength by mixing normals",
        "Goes from the smooth normal to the bumped one, as the strength of Blender's bump node "
        "does. Wrong: slopes do not scale by the amount, and above 1 it runs away.")
        .in<Normal>("smooth", surface::normal, "The normal without the bump, object space")
        .in<Normal>("bumped", surface::normal, "The normal with it, object space")
        .in<Float>("amount", 1, "0 is smooth, 1 is bumped", slider(0, 1))
        .out<Normal>("normal", "Unit normal in object space")
        .body([](vec3 smooth, vec3 bumped, Float amount) {
            return normalize(mix(smooth, bumped, amount));
        }),

    // Tangent and bitangent from dP = T du + B dv over the pixel, without division by the
    // determinant.
    comparison_family(
        "compare_engine_basis", "Wrong: unprojected derived basis",
        "A tangent-space normal in a basis derived from position and uv alone. Wrong: the basis "
        "is not brought to the normal's tangent plane, so facets show, and without the sign of "
        "the determinant mirrored uvs turn hills into dents.")
        .in<vec3>("normal", {0, 0, 1}, "In tangent space, any length")
        .in<vec2>("uv", surface::uv0, "The uv whose directions its x and y are")
        .out<Normal>("bumped", "Unit normal in object space")
        .body([](vec3 m, vec2 uv) {
            const vec3 px = ddx(vec3(surface::position)), py = ddy(vec3(surface::position));
            const vec2 ux = ddx(uv), uy = ddy(uv);
            const vec3 tangent = normalize(px * uy.y() - py * ux.y());
            const vec3 bitangent = normalize(py * ux.x() - px * uy.x());
            const vec3 normal = surface::normal;
            return normalize(tangent * m.x() + bitangent * m.y() + normal * m.z());
        }),

    comparison_family(
        "compare_bump_blend", "Wrong: bumps blended as normals",
        "A blend of detail maps, applied to two bumps as tangent-space normals of uv0. "
        "Wrong as the blends are; in place of Add bumps it shows by how much. "
        "partial_derivative is right.")
        .in<Gradient>("a", "The coarse bump")
        .in<Gradient>("b", "The fine bump")
        .choice("blend", {"udn", "whiteout", "rnm", "linear", "partial_derivative"},
                "Which of the nodes with these names")
        .out<Gradient>("gradient", "The bump of the blended normal")
        .body([](Gradient a, Gradient b, BumpBlend blend) {
            const Frame basis = frame(surface::uv0, Scale::unit);
            const vec3 along_u = Gradient(Derivative(vec2(1, 0), basis)).vector();
            const vec3 along_v = Gradient(Derivative(vec2(0, 1), basis)).vector();
            const auto tangent_normal = [&](Gradient g) {
                const vec3 slope = g.vector();
                return normalize(vec3(-dot(along_u, slope), -dot(along_v, slope), 1));
            };
            const vec3 n = blended(tangent_normal(a), tangent_normal(b), blend);
            return Gradient(normal_derivative(n, 1, basis));
        }),

    // Listing 2 and eq. 3 of M. Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU"
    // (2010).
    comparison_family(
        "compare_screen_height", "Wrong: bump from screen differences",
        "Reads a height here and at the next pixels and takes the differences. Wrong: close up a "
        "texture shows its facets, and the height is computed three times; gradient_from_height "
        "has the slope itself.")
        .field<Height>("height", surface::uv0, "A height over uv0, in length units of object space")
        .choice("pixel", {"lengths", "unit"},
                "Length of the pixel's axes: as they are, or made unit as in three.js: "
                "then the bump fades as the viewer comes closer")
        .out<Normal>("normal", "Unit normal in object space")
        .body([](Field<Float> height, PixelAxes axes) {
            const vec2 uv = surface::uv0;
            const vec3 n = surface::normal;
            vec3 px = ddx(vec3(surface::position)), py = ddy(vec3(surface::position));
            if (axes == PixelAxes::unit) px = normalize(px), py = normalize(py);
            const Float here = height(uv);
            const Float dx = height(uv + ddx(uv)) - here, dy = height(uv + ddy(uv)) - here;
            const vec3 r1 = cross(py, n), r2 = cross(n, px);
            const Float det = dot(px, r1);
            return normalize(n * abs(det) - (r1 * dx + r2 * dy) * sign_nonzero(det));
        })};
constinit std::span<Node> comparison_surface_nodes = comparison_surface_list;

}  // namespace wrinkle::nodes
