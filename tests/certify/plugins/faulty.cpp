// Nodes with one fault each, which certification must report.
#include <stdexcept>

#include "wrinkle/node.h"

using namespace wrinkle::sdk;

static constexpr auto height_of(const char* id, const char* doc) {
    return node(id, "Faulty", doc).family("test").in<vec2>("uv", surface::uv0, "Where to read it");
}

// Declares that terraces are continuous.
static Node terraces =
    height_of("terraces", "Steps with a slope that is not theirs.")
        .out<Height>("height", "In length units", unit("m"))
        .body([](vec2 uv) {
            return with_slope(floor(4 * uv.x()) * 0.25, uv, vec2(Float(1), Float(0)));
        });

static Node stiff = height_of("stiff", "A wave whose slope was lost.")
                        .out<Height>("height", "In length units", unit("m"))
                        .body([](vec2 uv) { return detach(sin(6 * uv.x())); });

static Node dusty = height_of("dusty", "A zigzag finer than any pixel.")
                        .out<Height>("height", "In length units", unit("m"))
                        .body([](vec2 uv) { return abs(fract(20000 * uv.x()) - 0.5); });

static Node undocumented =
    node("undocumented", "Faulty", "Says too little")
        .family("test")
        .in<Float>("amount", 1, "amount")
        .in<Float>("angle", 0, "How far it is open", slider(-2, 2), limits(-1, 1))
        .in<Height>("level", 0, "")
        .out<Height>("height", "The relief")
        .body([](Float amount, Float angle, Float level) { return amount * angle + level; });

static Node divides = height_of("divides", "Divides by the size of a pixel.")
                          .out<Height>("height", "In length units", unit("m"))
                          .body([](vec2 uv) { return uv.x() / detach(length(ddx(uv))); });

static Node counting = height_of("counting", "Another height each time.")
                           .out<Height>("height", "In length units", unit("m"))
                           .body([](vec2 uv) {
                               static int count = 0;
                               return uv.x() * static_cast<double>(++count);
                           });

// The length of a unit vector is 1 up to the last bit.
static Node on_the_edge = node("on_the_edge", "Faulty", "Jumps where every point is.")
                              .family("test")
                              .in<vec3>("point", surface::position, "Where to read it")
                              .out<Height>("height", "In length units", unit("m"))
                              .body([](vec3 point) { return floor(length(normalize(point))); });

// A float of 1e12 does not fit an int: the contract leaves the result undefined.
static Node overflows = height_of("overflows", "Makes whole numbers of large ones.")
                            .out<Height>("height", "In length units", unit("m"))
                            .body([](vec2 uv) { return Float(Int(1e12 * uv.x())) * 1e-9; });

static Node coarse = height_of("coarse", "A wave too fine for a float.")
                         .out<Height>("height", "In length units", unit("m"))
                         .body([](vec2 uv) { return sin(detach(uv.x()) + 1e5) * 1e5 + 1e8; });

static Node throws = height_of("throws", "Gives up.")
                         .out<Height>("height", "In length units", unit("m"))
                         .body([](vec2 uv) -> Float {
                             if (uv.id != 0) throw std::runtime_error("no height today");
                             return 0;
                         });

WRINKLE_PLUGIN("faulty", "1.0", terraces, stiff, dusty, undocumented, divides, counting,
               on_the_edge, overflows, coarse, throws)
