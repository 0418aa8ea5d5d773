// Arithmetic on scalars. Results are finite for finite inputs, except on overflow.
#include <span>

#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto math_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("math");
}

static constinit Node math_list[] = {
    math_family("add", "Add", "The sum of two numbers.")
        .in<Float>("a", 0, "One number")
        .in<Float>("b", 0, "The other number")
        .out<Float>("result", "a + b")
        .body([](Float a, Float b) { return a + b; }),

    math_family("subtract", "Subtract", "The difference of two numbers.")
        .in<Float>("a", 0, "The number to take from")
        .in<Float>("b", 0, "The number to take away")
        .out<Float>("result", "a - b")
        .body([](Float a, Float b) { return a - b; }),

    math_family("multiply", "Multiply", "The product of two numbers.")
        .in<Float>("a", 1, "One factor")
        .in<Float>("b", 1, "The other factor")
        .out<Float>("result", "a b")
        .body([](Float a, Float b) { return a * b; }),

    math_family("divide", "Divide", "The quotient of two numbers; 0 where the divisor is 0.")
        .in<Float>("a", 1, "The number to divide")
        .in<Float>("b", 1, "The divisor")
        .out<Float>("result", "a / b")
        .body([](Float a, Float b) { return divide(a, b); }),

    math_family("negate", "Negate", "The number with the other sign.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "-x")
        .body([](Float x) { return -x; }),

    math_family("absolute", "Absolute", "The number without its sign.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "x or -x, whichever is not negative")
        .body([](Float x) { return abs(x); }),

    math_family("minimum", "Minimum", "The lesser of two numbers.")
        .in<Float>("a", 0, "One number")
        .in<Float>("b", 0, "The other number")
        .out<Float>("result", "The lesser")
        .body([](Float a, Float b) { return min(a, b); }),

    math_family("maximum", "Maximum", "The greater of two numbers.")
        .in<Float>("a", 0, "One number")
        .in<Float>("b", 0, "The other number")
        .out<Float>("result", "The greater")
        .body([](Float a, Float b) { return max(a, b); }),

    math_family("clamp", "Clamp",
                "Keeps a number within bounds; where they cross, the upper one holds.")
        .in<Float>("x", 0, "The number")
        .in<Float>("low", 0, "The lower bound")
        .in<Float>("high", 1, "The upper bound")
        .out<Float>("result", "low to high")
        .body([](Float x, Float low, Float high) { return clamp(x, low, high); }),

    math_family("mix", "Mix", "Goes from one number to another.")
        .in<Float>("a", 0, "The number where the mask is 0")
        .in<Float>("b", 1, "The number where the mask is 1")
        .in<Float>("mask", 0.5, "0 is a, 1 is b", slider(0, 1))
        .out<Float>("result", "(1 - mask) a + mask b")
        .body([](Float a, Float b, Float mask) { return mix(a, b, mask); }),

    math_family("step", "Step", "0 below an edge, 1 from it on; it has no bump.")
        .in<Float>("edge", 0.5, "Where it jumps")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "0 or 1")
        .body([](Float edge, Float x) { return step(edge, x); }),

    math_family("smoothstep", "Smooth step",
                "0 below one edge, 1 above another, smooth between; falls where the edges stand in "
                "falling order.")
        .in<Float>("low", 0, "Where it leaves 0")
        .in<Float>("high", 1, "Where it reaches 1")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "0 to 1")
        .body([](Float low, Float high, Float x) { return smoothstep(low, high, x); }),

    math_family("remap", "Remap",
                "Brings one range to another; to_low where the old range is empty.")
        .in<Float>("x", 0, "The number; beyond the old range it goes on straight")
        .in<Float>("from_low", 0, "Start of the old range")
        .in<Float>("from_high", 1, "End of the old range")
        .in<Float>("to_low", 0, "What the start becomes")
        .in<Float>("to_high", 1, "What the end becomes")
        .out<Float>("result", "In the new range")
        .body([](Float x, Float from_low, Float from_high, Float to_low, Float to_high) {
            return mix(to_low, to_high, divide(x - from_low, from_high - from_low));
        }),

    math_family("floor", "Floor", "The greatest whole number that is not greater; it has no bump.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "A whole number")
        .body([](Float x) { return floor(x); }),

    math_family("fraction", "Fraction", "What is left above the floor: a saw tooth.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "0 to 1")
        .body([](Float x) { return fract(x); }),

    math_family(
        "modulo", "Modulo",
        "The remainder of a division, with the sign of the divisor; 0 where the divisor is 0.")
        .in<Float>("x", 0, "The number to divide")
        .in<Float>("divisor", 1, "The length of one period")
        .out<Float>("result", "0 to divisor")
        .body([](Float x, Float divisor) { return mod(x, divisor); }),

    math_family("power", "Power",
                "A number to a power. A negative base counts as 0; 0 to a negative power is 0.")
        .in<Float>("base", 1, "The number")
        .in<Float>("exponent", 2, "The power", slider(0, 8))
        .out<Float>("result", "base to the exponent")
        .body([](Float base, Float exponent) { return pow(base, exponent); }),

    math_family("square_root", "Square root", "The square root; of a negative number 0.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "Not negative")
        .body([](Float x) { return sqrt(x); }),

    math_family("sine", "Sine", "The sine of an angle.")
        .in<Float>("angle", 0, "In radians", unit("rad"))
        .out<Float>("result", "-1 to 1")
        .body([](Float angle) { return sin(angle); }),

    math_family("cosine", "Cosine", "The cosine of an angle.")
        .in<Float>("angle", 0, "In radians", unit("rad"))
        .out<Float>("result", "-1 to 1")
        .body([](Float angle) { return cos(angle); }),

    math_family("tangent", "Tangent", "The tangent of an angle; huge near a quarter turn.")
        .in<Float>("angle", 0, "In radians", unit("rad"))
        .out<Float>("result", "Slope of the angle")
        .body([](Float angle) { return tan(angle); }),

    math_family("arctangent2", "Arctangent of y, x",
                "The angle of a direction in the plane; 0 for the origin.")
        .in<Float>("y", 0, "Second coordinate")
        .in<Float>("x", 1, "First coordinate")
        .out<Float>("result", "In radians, -pi to pi, anticlockwise from the x axis")
        .body([](Float y, Float x) { return atan(y, x); })};
constinit std::span<Node> math_nodes = math_list;

}  // namespace wrinkle::nodes
