// Arithmetic on scalars. Results are finite for finite inputs, except on overflow.
#include <span>

#include "wrinkle/node.h"

namespace wrinkle::nodes {
using namespace sdk;

static constexpr auto math_family(const char* id, const char* title, const char* doc) {
    return node(id, title, doc).family("math");
}

// asin() and acos() of some drivers are off by 4e-4, atan() is not.
static Float cosine_of_arcsine(Float x) {
    return named("cosine", sqrt((1 - x) * (1 + x)));
}

struct Comparison {
    Float a, b;
    Choice which;
    Float tolerance, yes, no;
};
static Bool holds(const Comparison& in) {
    const Bool results[] = {in.a<in.b, in.a <= in.b, in.a> in.b, in.a >= in.b,
                            abs(in.a - in.b) <= in.tolerance};
    return results[static_cast<int>(in.which)];
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
                "0 below one edge, 1 above another, smooth between; falls where the first edge is "
                "the higher one.")
        .in<Float>("low", 0, "Where it leaves 0")
        .in<Float>("high", 1, "Where it reaches 1")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "0 to 1")
        .body([](Float low, Float high, Float x) { return smoothstep(low, high, x); }),

    math_family("remap", "Remap",
                "Brings one range to another; to_low where the old range is empty.")
        .in<Float>("x", 0, "The number; beyond the old range the line continues")
        .in<Float>("from_low", 0, "Start of the old range")
        .in<Float>("from_high", 1, "End of the old range")
        .in<Float>("to_low", 0, "Start of the new range")
        .in<Float>("to_high", 1, "End of the new range")
        .out<Float>("result", "In the new range")
        .body([](Float x, Float from_low, Float from_high, Float to_low, Float to_high) {
            return mix(to_low, to_high, divide(x - from_low, from_high - from_low));
        }),

    math_family("floor", "Floor", "The greatest whole number that is not greater; it has no bump.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "A whole number")
        .body([](Float x) { return floor(x); }),

    math_family("fraction", "Fraction", "The part above the floor: a saw tooth.")
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
        .body([](Float y, Float x) { return atan(y, x); }),

    math_family("arcsine", "Arcsine", "The angle that has a sine.")
        .in<Float>("x", 0, "The sine; limited to -1 to 1", slider(-1, 1))
        .out<Float>("result", "In radians, -pi / 2 to pi / 2")
        .body([](Float x) { return atan(clamp(x, -1, 1), cosine_of_arcsine(x)); }),

    math_family("arccosine", "Arccosine", "The angle that has a cosine.")
        .in<Float>("x", 0, "The cosine; limited to -1 to 1", slider(-1, 1))
        .out<Float>("result", "In radians, 0 to pi")
        .body([](Float x) { return atan(cosine_of_arcsine(x), clamp(x, -1, 1)); }),

    math_family("arctangent", "Arctangent", "The angle that has a tangent.")
        .in<Float>("x", 0, "The tangent")
        .out<Float>("result", "In radians, -pi / 2 to pi / 2")
        .body([](Float x) { return atan(x); }),

    math_family("to_radians", "To radians", "An angle in radians.")
        .in<Float>("angle", 0, "In degrees", slider(-180, 180), unit("deg"))
        .out<Float>("result", "In radians")
        .body([](Float angle) { return radians(angle); }),

    math_family("to_degrees", "To degrees", "An angle in degrees.")
        .in<Float>("angle", 0, "In radians", slider(-3.14159, 3.14159), unit("rad"))
        .out<Float>("result", "In degrees")
        .body([](Float angle) { return degrees(angle); }),

    math_family("exponential", "Exponential", "e to a power.")
        .in<Float>("x", 0, "The power", slider(-4, 4))
        .out<Float>("result", "e^x")
        .body([](Float x) { return exp(x); }),

    math_family("logarithm", "Logarithm",
                "The power that gives a number; of 0 and below that of the least number, and 0 "
                "for a base that has none.")
        .in<Float>("x", 1, "The number", slider(0, 8))
        .in<Float>("base", 2.718281828459045, "The base", slider(2, 10))
        .out<Float>("result", "The power of the base")
        .body([](Float x, Float base) { return divide(log(x), select(base > 0, log(base), 0)); }),

    math_family("hypotenuse", "Hypotenuse", "The long side of a right-angled triangle.")
        .in<Float>("a", 3, "One side")
        .in<Float>("b", 4, "The other side")
        .out<Float>("result", "The root of a a + b b")
        .body([](Float a, Float b) { return length(vec2(a, b)); }),

    math_family("reciprocal", "Reciprocal", "1 by a number; 0 where it is 0.")
        .in<Float>("x", 1, "The number")
        .out<Float>("result", "1 / x")
        .body([](Float x) { return divide(1, x); }),

    math_family("safe_power", "Safe power", "A number to a power, with the sign of the number.")
        .in<Float>("base", 1, "The number")
        .in<Float>("exponent", 2, "The power", slider(0, 8))
        .out<Float>("result", "sign(base) |base|^exponent")
        .body([](Float base, Float exponent) { return sign(base) * pow(abs(base), exponent); }),

    math_family("multiply_add", "Multiply and add", "A product and a sum in one.")
        .in<Float>("a", 1, "One factor")
        .in<Float>("b", 1, "The other factor")
        .in<Float>("c", 0, "Added to the product")
        .out<Float>("result", "a b + c")
        .body([](Float a, Float b, Float c) { return a * b + c; }),

    math_family("ceiling", "Ceiling", "The least whole number that is not less; it has no bump.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "A whole number")
        .body([](Float x) { return ceil(x); }),

    math_family("round", "Round", "The nearest whole number, the upper one of two.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "A whole number")
        .body([](Float x) { return floor(x + 0.5); }),

    math_family("truncate", "Truncate", "The number without its fraction, towards 0.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "A whole number")
        .body([](Float x) { return sign(x) * floor(abs(x)); }),

    math_family("sign", "Sign", "-1, 0 or 1: the side of 0 that a number is on.")
        .in<Float>("x", 0, "The number")
        .out<Float>("result", "-1, 0 or 1")
        .body([](Float x) { return sign(x); }),

    math_family("compare", "Compare", "One of two numbers, by a comparison of two others.")
        .in<Float>("a", 0, "The number to compare")
        .in<Float>("b", 0, "The number to compare with")
        .choice("comparison", {"less", "less_equal", "greater", "greater_equal", "equal"},
                "How a is related to b where it holds", 2)
        .in<Float>("tolerance", 1e-6, "Difference up to which numbers are equal", slider(0, 1),
                   limits(0, 1e30))
        .in<Float>("yes", 1, "Result where it holds")
        .in<Float>("no", 0, "Result elsewhere")
        .out<Float>("result", "yes or no")
        .body([](Comparison in) { return select(holds(in), in.yes, in.no); })};
constinit std::span<Node> math_nodes = math_list;

}  // namespace wrinkle::nodes
