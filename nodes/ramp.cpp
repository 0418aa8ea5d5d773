// Colors and numbers by a number, through points of the user.
#include <array>
#include <span>

#include "nodes/color_space.h"
#include "nodes/footprint.h"
#include "nodes/spline.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr int most_stops = 10, most_points = 8;
static constexpr const char* positions[] = {"position_1", "position_2", "position_3", "position_4",
                                            "position_5", "position_6", "position_7", "position_8",
                                            "position_9", "position_10"};
static constexpr const char* colors[] = {"color_1", "color_2", "color_3", "color_4", "color_5",
                                         "color_6", "color_7", "color_8", "color_9", "color_10"};
static constexpr const char* points[] = {"point_1", "point_2", "point_3", "point_4",
                                         "point_5", "point_6", "point_7", "point_8"};

template <int k = 0, class Declaration>
static constexpr auto with_stops(const Declaration& declaration) {
    if constexpr (k == most_stops)
        return declaration;
    else
        return with_stops<k + 1>(
            declaration
                .template in<Float>(positions[k], k == 0 ? 0 : 1,
                                    "Position of the stop, 0 to 1; one below that of the stop "
                                    "before counts as equal, a hard edge",
                                    slider(0, 1), limits(0, 1))
                .template in<Color>(colors[k], k == 0 ? 0 : 1, "Color of the stop, linear",
                                    slider(0, 1)));
}

template <int k = 0, class Declaration>
static constexpr auto with_points(const Declaration& declaration) {
    if constexpr (k == most_points)
        return declaration;
    else
        return with_points<k + 1>(declaration.template in<vec2>(
            points[k], k == 0 ? 0 : 1,
            "Position and value of the point; a position below that of the point before counts as "
            "equal, a hard edge",
            slider(0, 1)));
}

struct Ramp {
    Float factor;
    int stops;
    struct {
        Float position;
        vec3 color;
    } stop[most_stops];
    Choice interpolation, space;
    Float detail;
};

static vec3 color_of(const Ramp& in) {
    Knots<vec3> knots;
    for (int k = 0; k < in.stops; ++k) {
        knots.position.push_back(in.stop[k].position);
        knots.value.push_back(in_space(in.space, in.stop[k].color));
    }
    // The box of detail 0 is the range of the factor.
    const Float factor = named("factor", mix(0.5, in.factor, in.detail));
    const Float width = max(box_width(in.factor), 1 - in.detail);
    return from_space(in.space, named("color", spline(knots, in.interpolation, factor, width)));
}

struct Curve {
    Float value;
    int points;
    vec2 point[most_points];
    Choice interpolation;
};

static constinit Node ramp_list[] = {
    with_stops(node("ramp", "Color ramp",
                    "Maps a number to a color: stops at positions from 0 to 1, the end colors "
                    "outside. Filtered: the mean over the pixel.")
                   .family("color")
                   .in<Float>("factor", 0, "Position in the ramp, 0 to 1", slider(0, 1))
                   .count("stops", 2, 2, most_stops, "How many stops are used, from the first"))
        .choice("interpolation", interpolation_names,
                "Between two stops: the left color, straight, eased, or a smooth curve through "
                "all stops that never overshoots",
                static_cast<int>(Interpolation::linear))
        .choice("space", {"linear", "display", "oklab"},
                "Where colors are mixed: linear light, sRGB display values, or OKLab, where equal "
                "steps look equal")
        .in<Float>("detail", 1,
                   "1 is the color at the factor, 0 the mean of the ramp; wire the detail of "
                   "cells for random factors",
                   slider(0, 1), limits(0, 1))
        .out<Color>("color", "The color, linear")
        .out<Float>("value", "Its luminance")
        .body([](Ramp in) {
            const vec3 color = color_of(in);
            return std::tuple{color, luminance(color)};
        }),

    with_points(node("curve", "Curve",
                     "Maps a number through a curve of points, constant outside. Filtered: the "
                     "mean over the pixel.")
                    .family("value")
                    .in<Float>("value", 0, "The number", slider(0, 1))
                    .count("points", 2, 2, most_points, "How many points are used, from the first"))
        .choice("interpolation", interpolation_names,
                "Between two points: the left value, straight, eased, or a smooth curve through "
                "all points that never overshoots",
                static_cast<int>(Interpolation::smooth))
        .out<Float>("value", "The value of the curve")
        .body([](Curve in) {
            Knots<Float> knots;
            for (int k = 0; k < in.points; ++k) {
                knots.position.push_back(in.point[k].x());
                knots.value.push_back(in.point[k].y());
            }
            return spline(knots, in.interpolation, in.value, box_width(in.value));
        })};
constinit std::span<Node> ramp_nodes = ramp_list;

}  // namespace wrinkle::nodes
