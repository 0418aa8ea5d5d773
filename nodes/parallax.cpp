// Relief that shifts with the view: maps are read at the point below the surface where the view ray
// hits the relief. March, bump and position use the same height and therefore the same scale.
//
// Sources: ProjectVecToTextureSpace, TexSpaceOffsToSurface and the level of detail of Mikkelsen's
// framework; segment intersection at the end of the march as in its parallax occlusion.
#include <span>

#include "nodes/constants.h"
#include "nodes/ports.h"
#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

constexpr char relief_uv_doc[] =
    "Where the relief begins: the height is read at uvs shifted from here";
constexpr char relief_out_uv_doc[] =
    "Where the eye meets the relief; its changes between pixels are those of the unshifted uv";
constexpr char relief_height_doc[] = "The height there, in length units of object space";

// Least sine of the angle between view and surface (about 6 degrees); lower views are clamped.
constexpr double lowest_view = 0.1;

// Converts a direction in space to an offset in uv: its tangential part is a x + b y, where x and y
// are the screen differentials of the position; the offset is a and b times those of uv. Returns
// zero if the position's differentials are zero.
static vec2 in_texture_space(vec3 direction, vec2 uv) {
    const vec3 n = surface::normal;
    const auto tangential = [n](vec3 v) { return v - n * dot(n, v); };
    const vec3 x = tangential(ddx<vec3>(surface::position));
    const vec3 y = tangential(ddy<vec3>(surface::position));
    const vec3 across_y = named("across_y", cross(y, n)), across_x = named("across_x", cross(n, x));
    const Float det = named("det", dot(x, across_y));
    const Float inverse = named("inverse_det", sign_nonzero(det) / max(abs(det), min_area()));
    const vec2 along_x = ddx(uv) * dot(direction, across_y);
    return (named("along_x", along_x) + ddy(uv) * dot(direction, across_x)) * inverse;
}

// Direction of the view ray below the surface, per length unit of depth.
struct Descent {
    vec3 in_space;
    vec2 in_uv;
    Float sine;  // sine of the angle between view and normal
};

static Descent descent(vec2 uv) {
    const vec3 n = surface::normal, view = surface::view;
    const Float cosine = named("cosine", dot(n, view));
    const vec3 sideways = named("sideways", view - n * cosine);
    const Float per_depth = named("per_depth", -1 / max(abs(cosine), lowest_view));
    return {named("descent", sideways * per_depth - n),
            named("uv_descent", in_texture_space(sideways, uv) * per_depth), length(sideways)};
}

// The segment of the view ray that enters the relief: depth of the first end and how far the ray is
// below the relief there, then the same for the second end.
using Stretch = std::tuple<Float, Float, Float, Float>;

static Float meeting(Float depth0, Float under0, Float depth1, Float under1) {
    return depth0 + (depth1 - depth0) * divide(under0, under0 - under1);
}

template <class Under>
static Stretch march(Under under, Float deepest, Float sine, int steps) {
    const Float step = named("depth_step", deepest / max(steps * (0.25 + 0.75 * sine), 1));
    const Float first = named("first", under(Float(0)));
    return loop(
        "march(depth_before, under_before, depth, under)", static_cast<uint32_t>(steps) + 1,
        std::tuple{Float(0), first, Float(0), first}, [&](Float, Float, Float depth, Float below) {
            const Float next = named("next", min(depth + step, deepest));
            return std::tuple{below < 0 && depth < deepest, depth, below, next, under(next)};
        });
}

template <class Under>
static Stretch narrowed(Under under, Stretch stretch, int times) {
    if (times == 0) return stretch;
    return loop("narrowed(depth_above, under_above, depth_below, under_below)",
                static_cast<uint32_t>(times), stretch,
                [&](Float depth0, Float under0, Float depth1, Float under1) {
                    const Float depth = named("meeting", meeting(depth0, under0, depth1, under1));
                    const Float here = named("here", under(depth));
                    const Bool above = named("above", here < 0);
                    return std::tuple{under1 > 0, select(above, depth, depth0),
                                      select(above, here, under0), select(above, depth1, depth),
                                      select(above, under1, here)};
                });
}

// Returns how much wider a pixel is on the relief than on the surface, in mip levels: the relief is
// farther from the eye, and tilted.
static Float level_change(Gradient relief, Float way, Float eye_distance) {
    const Float min_cosine = named("min_cosine // of a relief seen edge-on", Float(1.19e-15));
    const Float least = named("min_change // 2^-20, of a pixel's extent", Float(1.0 / (1 << 20)));
    const vec3 view = surface::view, before = surface::normal;
    const Float farther = 1 + divide(way, eye_distance);
    const Float turned = abs(dot(before, view)) / max(abs(dot(resolve(relief), view)), min_cosine);
    return 0.5 * log2(max(farther * farther * turned, least));
}

struct ParallaxOcclusion {
    Field<Float> height;
    vec2 uv;
    Float top, depth;
    int steps, refinements;
    Float eye_distance;
};

enum class OffsetLimit { limited, full };
static constinit Node parallax_list[] = {
    node("parallax_occlusion", "Parallax occlusion",
         "A relief cut into the surface, seen at its depth: parts shift and hide each other. One "
         "height gives march, bump and position.")
        .family("parallax")
        .field<Height>("height", surface::uv0,
                       "The relief as made from uv0, in length units of object space; the same "
                       "everywhere if it is not")
        .in<vec2>("uv", surface::uv0, relief_uv_doc)
        .in<Height>("top", 0,
                    "The height that lies in the surface itself, in length units of object space; "
                    "higher values are cut off",
                    slider(-0.2, 0.2), unit("m"))
        .in<Float>("depth", 0.1,
                   "How far the relief reaches below the top, in length units of object space",
                   slider(0, 0.5), limits(0, 1e6), unit("m"))
        .count("steps", 32, 4, 256, "Steps of the march at a grazing view; straight down a quarter")
        .count("refinements", 3, 0, 8, "How often the place found is made more exact")
        .in<Float>("eye_distance", 0,
                   "From the eye to the surface in length units of object space, for the level of "
                   "detail; 0: far away",
                   slider(0, 100), limits(0, 1e12), unit("m"))
        .out<vec2>("uv", relief_out_uv_doc)
        .out<vec2>("detail_uv",
                   "The same place, its changes between pixels those on the relief: for colors "
                   "and normal maps on top, not for heights")
        .out<Height>("height", relief_height_doc, unit("m"))
        .out<vec3>("position", "The place in object space, in length units")
        .out<Gradient>("gradient", "The bump of that height there")
        .out<Float>("lod", "Levels by which a pixel is wider on the relief than on the surface")
        .body([](ParallaxOcclusion in) {
            const Descent down = descent(in.uv);
            const auto under = [&](Float depth) {
                return in.height(in.uv + down.in_uv * depth) - in.top + depth;
            };
            const auto [depth0, under0, depth1, under1] =
                narrowed(under, march(under, in.depth, down.sine, in.steps), in.refinements);
            const Float depth = select(under1 < 0, depth1, meeting(depth0, under0, depth1, under1));
            const vec2 uv = in.uv + detach(down.in_uv * depth);
            const Float height = in.height(uv);
            const Gradient relief = gradient_from_height(height);
            const Float lod = level_change(relief, length(down.in_space) * depth, in.eye_distance);
            const vec2 detail_uv = detach(uv) + detach(exp2(lod)) * (in.uv - detach(in.uv));
            const vec3 position = surface::position + detach(down.in_space * depth);
            return std::tuple{uv, detail_uv, height, position, relief, lod};
        }),

    node("parallax_offset", "Parallax offset",
         "A relief that shifts with the view, by one step: cheap, right for gentle slopes, "
         "without occlusion.")
        .family("parallax")
        .field<Height>("height", surface::uv0,
                       "The relief as made from uv0, in length units of object space")
        .in<vec2>("uv", surface::uv0, relief_uv_doc)
        .in<Height>("middle", 0, "The height that does not shift, in length units of object space",
                    slider(-0.2, 0.2), unit("m"))
        .choice("method", {"limited", "full"},
                "limited: at most by the height, which a grazing view needs; full: as far as the "
                "view goes at that height")
        .out<vec2>("uv", relief_out_uv_doc)
        .out<Height>("height", relief_height_doc, unit("m"))
        .out<Gradient>("gradient", "The bump of that height there")
        .body([](Field<Float> field, vec2 start, Float middle, OffsetLimit method) {
            const Float lift = field(start) - middle;
            const vec3 view = surface::view;
            const vec2 limited = -in_texture_space(view, start);
            const vec2 per_depth = method == OffsetLimit::full ? descent(start).in_uv : limited;
            const vec2 uv = start + detach(per_depth * -lift);
            const Float height = field(uv);
            return std::tuple{uv, height, gradient_from_height(height)};
        })};
constinit std::span<Node> parallax_nodes = parallax_list;

}  // namespace wrinkle::nodes
