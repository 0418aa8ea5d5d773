// Common blends of two tangent-space normals, for comparison with the addition of slopes. Angles
// are between the result and the sum, over all pairs of normals tilted up to 45 degrees. Sources:
// C. Barre-Brisebois and S. Hill, "Blending in Detail" (2012); the node libraries of Babylon.js,
// MaterialX, three.js and Unity.
#include <span>

#include "nodes/blend.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

#define TANGENT_SPACE "unit, in tangent space: as read from a normal map"

// The ports of all blends.
static constexpr auto blend(const char* id, const char* title, const char* doc) {
    return comparison_family(id, title, doc)
        .in<vec3>("base", {0, 0, 1}, "The coarse normal, " TANGENT_SPACE)
        .in<vec3>("detail", {0, 0, 1}, "The fine normal, " TANGENT_SPACE)
        .out<vec3>("normal", "Unit normal in tangent space");
}

// Overlay blend of one color channel; arguments and result are in [-1, 1].
static Float overlaid(Float a, Float b) {
    const Float x = a * 0.5 + 0.5, y = b * 0.5 + 0.5;
    return 2 * select(x < 0.5, 2 * x * y, 1 - 2 * (1 - x) * (1 - y)) - 1;
}

enum class Blue { overlay, product };
enum class StrengthRule { unity, rebuilt };

static constinit Node comparison_list[] = {
    blend("compare_linear", "Wrong: linear blend",
          "The average of two normals. Wrong: each halves the other, and a flat layer flattens. "
          "14.3 degrees off on average.")
        .body([](vec3 a, vec3 b) { return linear_blend(a, b); }),

    blend("compare_overlay", "Wrong: overlay blend",
          "The overlay of two normal maps as if they were colors. Wrong: the order matters, and "
          "a flat detail changes the base. 6.7 degrees off on average, 32 at worst.")
        .choice("blue", {"overlay", "product"},
                "How the third channel is made: as the others, or multiplied, as in Babylon.js")
        .body([](vec3 a, vec3 b, Blue blue) {
            const Float product = (a.z() * 0.5 + 0.5) * (b.z() * 0.5 + 0.5) * 2 - 1;
            return normalize(vec3(overlaid(a.x(), b.x()), overlaid(a.y(), b.y()),
                                  blue == Blue::product ? product : overlaid(a.z(), b.z())));
        }),

    blend("compare_whiteout", "Wrong: whiteout blend",
          "Adds x and y, multiplies z. Wrong: steep slopes are exaggerated, and grouping of three "
          "layers matters. 2.1 degrees off on average.")
        .body([](vec3 a, vec3 b) { return whiteout_blend(a, b); }),

    blend("compare_udn", "Wrong: UDN blend",
          "Adds x and y, keeps the z of the base. Wrong: the detail grows on a steep base, and "
          "fades on a flat one. 2.0 degrees off on average.")
        .body([](vec3 a, vec3 b) { return udn_blend(a, b); }),

    blend("compare_partial_derivative", "Partial derivative blend",
          "Adds the slopes of two tangent-space normals. Right, and the same as gradient_add, but "
          "only for two maps on one uv set.")
        .body([](vec3 a, vec3 b) { return partial_derivative_blend(a, b); }),

    blend("compare_rnm", "Other meaning: reoriented normal mapping",
          "Turns the detail by the rotation from z to the base. Another meaning, not a sum: the "
          "order matters, and slopes do not add. 3.1 degrees off on average, 25 at worst.")
        .body([](vec3 a, vec3 b) { return rnm_blend(a, b); }),

    blend("compare_unity", "Wrong: Unity basis blend",
          "Reads the detail in a matrix made of the base. Wrong: the matrix is not a rotation, "
          "and the order matters. 5.8 degrees off on average, 36 at worst.")
        .body([](vec3 a, vec3 b) {
            const vec3 x(a.z(), a.y(), -a.x()), y(a.x(), a.z(), -a.y());
            return normalize(x * b.x() + y * b.y() + a * b.z());
        }),

    blend("compare_nested_frame", "Wrong: nested normal maps",
          "Reads the detail in the frame of the surface with the base for its third axis, as "
          "normal maps chained in MaterialX do. Wrong: that frame is not orthogonal. 2.0 degrees "
          "off on average, 21 at worst.")
        .body([](vec3 a, vec3 b) { return normalize(vec3(b.xy(), 0) + a * b.z()); }),

    // Evaluated on a plane, where the pixel's axes are those of the tangent frame.
    blend("compare_bump_over_normal", "Wrong: bump over a bent normal",
          "Perturbs the base by eq. 3 with the base in place of the surface's normal, as a bump "
          "map over a normal map does in three.js. Wrong: the detail grows on steep slopes. 4.3 "
          "degrees off on average, 35 at worst.")
        .body([](vec3 a, vec3 b) {
            const vec2 slope = divide(-b.xy(), b.z());
            const vec3 r1 = cross(vec3(0, 1, 0), a), r2 = cross(a, vec3(1, 0, 0));
            return normalize(a.z() * a - (r1 * slope.x() + r2 * slope.y()));
        }),

    comparison_family(
        "compare_normal_strength", "Wrong: strength of a normal",
        "Scales x and y of a tangent-space normal and computes z from them. Wrong: slopes do not "
        "scale by "
        "the amount; gradient_scale does, and so do x and y scaled with z left alone.")
        .in<vec3>("normal", {0, 0, 1}, "Unit, in tangent space")
        .in<Float>("amount", 1, "1 leaves it unchanged", slider(0, 2), unit("x"))
        .choice("rule", {"unity", "rebuilt"},
                "z goes from 1 to its value and stays there, as in Unity's node; or it is "
                "rebuilt for unit length, and slopes above that are vertical")
        .out<vec3>("scaled", "Unit normal in tangent space")
        .body([](vec3 n, Float amount, StrengthRule rule) {
            const vec2 xy = n.xy() * amount;
            if (rule == StrengthRule::unity)
                return normalize(vec3(xy, mix(1, n.z(), saturate(amount))));
            return normalize(vec3(xy, sqrt(1 - dot(xy, xy))));
        })};
constinit std::span<Node> comparison_nodes = comparison_list;

}  // namespace wrinkle::nodes
