// Colors: hue, saturation, luminance.
#include "import/mtlx_importer.h"

namespace wrinkle::materialx {
namespace {

Value rgb(NodeContext& context, const Numbers& numbers) {
    return context.graph().from_parts(context.type(), numbers);
}

Number luminance_of(NodeContext& context, const Value& in) {
    const Value weights = context.input(
        "lumacoeffs", Type::color3, literal_value(Type::color3, {0.2722287, 0.6740818, 0.0536895}));
    GraphBuilder& graph = context.graph();
    Number sum;
    for (int i = 0; i < 3; ++i)
        sum = graph.add(sum, graph.multiply(graph.part(in, i), graph.part(weights, i)));
    return sum;
}

Value luminance(NodeContext& context) {
    const Value in = context.input("in", context.type());
    const Number gray = luminance_of(context, in);
    if (context.failed()) return bad_value();
    Numbers parts = {gray, gray, gray};
    if (context.size() == 4) parts.push_back(context.graph().part(in, 3));
    return rgb(context, parts);
}

// mix(gray, in, amount)
Value saturate(NodeContext& context) {
    const Value in = context.input("in", context.type());
    const Number amount = context.number("amount", 1);
    const Number gray = luminance_of(context, in);
    if (context.failed()) return bad_value();
    Numbers parts;
    for (int i = 0; i < 3; ++i)
        parts.push_back(context.graph().math("mix", {"a", "b", "mask"},
                                             {gray, context.graph().part(in, i), amount}));
    if (context.size() == 4) parts.push_back(context.graph().part(in, 3));
    return rgb(context, parts);
}

Value hsv_adjust(NodeContext& context) {
    if (context.size() != 3) return context.fail("hsvadjust needs three numbers", "a color3");
    const Value in = context.input("in", Type::color3);
    const Value amount =
        context.input("amount", Type::vector3, literal_value(Type::vector3, {0, 1, 1}));
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    return wire_value(Type::color3, graph.add("hsv_adjust", "color",
                                              {graph.input("color", in),
                                               graph.input("hue", graph.part(amount, 0)),
                                               graph.input("saturation", graph.part(amount, 1)),
                                               graph.input("value", graph.part(amount, 2))}));
}

// Each channel is v (1 - s (1 - p)), p = clamp(|6 fract(h + k) - 3| - 1), k = 1, 2/3, 1/3.
Value hsv_to_rgb(NodeContext& context) {
    const Value in = context.input("in", context.type());
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    const Number h = graph.part(in, 0), s = graph.part(in, 1), v = graph.part(in, 2);
    Numbers parts;
    for (const double shift : {1.0, 2.0 / 3, 1.0 / 3}) {
        const Number turn = graph.math("fraction", {"x"}, {graph.add(h, {shift})});
        const Number way =
            graph.math("absolute", {"x"}, {graph.subtract(graph.multiply(turn, {6}), {3})});
        const Number pure =
            graph.math("clamp", {"x", "low", "high"}, {graph.subtract(way, {1}), {0}, {1}});
        const Number tint = graph.math("mix", {"a", "b", "mask"}, {{1}, pure, s});
        parts.push_back(graph.multiply(v, tint));
    }
    if (context.size() == 4) parts.push_back(graph.part(in, 3));
    return rgb(context, parts);
}

Number equal(GraphBuilder& graph, const Number& a, const Number& b, const Number& yes,
             const Number& no) {
    return {0, graph.add("compare", "result",
                         {graph.input("a", a), graph.input("b", b),
                          literal_input("comparison", json::Value::string("equal")),
                          graph.input("yes", yes), graph.input("no", no)})};
}

// Hue by the greatest channel, in turns: A. R. Smith, "Color gamut transform pairs", 1978.
Value rgb_to_hsv(NodeContext& context) {
    const Value in = context.input("in", context.type());
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    const Number r = graph.part(in, 0), g = graph.part(in, 1), b = graph.part(in, 2);
    const auto two = [&](const char* type, const Number& x, const Number& y) {
        return graph.math(type, {"a", "b"}, {x, y});
    };
    const Number most = two("maximum", r, two("maximum", g, b));
    const Number least = two("minimum", r, two("minimum", g, b));
    const Number range = graph.subtract(most, least);
    const auto sector = [&](double start, const Number& x, const Number& y) {
        return graph.add(graph.divide(graph.subtract(x, y), range), {start});
    };
    const Number rest = equal(graph, g, most, sector(2, b, r), sector(4, r, g));
    const Number sixths = equal(graph, r, most, sector(0, g, b), rest);
    const Number hue = graph.math("fraction", {"x"}, {graph.divide(sixths, {6})});
    Numbers parts = {hue, graph.divide(range, most), most};
    if (context.size() == 4) parts.push_back(graph.part(in, 3));
    return rgb(context, parts);
}

}  // namespace

std::span<const HandlerRow> color_handlers() {
    static constexpr std::array rows = {
        HandlerRow{"luminance", luminance},  HandlerRow{"saturate", saturate},
        HandlerRow{"hsvadjust", hsv_adjust}, HandlerRow{"hsvtorgb", hsv_to_rgb},
        HandlerRow{"rgbtohsv", rgb_to_hsv},
    };
    return rows;
}

}  // namespace wrinkle::materialx
