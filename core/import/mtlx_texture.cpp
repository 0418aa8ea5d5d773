#include "import/mtlx_texture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wrinkle::materialx {
namespace {

bool are(const Numbers& numbers, double value) {
    return std::ranges::all_of(numbers, [&](const Number& number) {
        return number.is_literal() && number.value == value;
    });
}

bool are_literal(const Numbers& numbers) {
    return std::ranges::all_of(numbers, &Number::is_literal);
}

struct Turn {
    double cosine, sine;
    explicit Turn(double degrees)
        : cosine(std::cos(degrees * std::numbers::pi / 180)),
          sine(std::sin(degrees * std::numbers::pi / 180)) {}
    double x(double u, double v) const { return cosine * u - sine * v; }
    double y(double u, double v) const { return sine * u + cosine * v; }
};

Numbers each(GraphBuilder& graph, const Numbers& a, const Numbers& b,
             Number (GraphBuilder::*operation)(const Number&, const Number&)) {
    return {(graph.*operation)(a[0], b[0]), (graph.*operation)(a[1], b[1])};
}

Numbers negated(GraphBuilder& graph, const Numbers& numbers) {
    return {graph.math("negate", {"x"}, {numbers[0]}), graph.math("negate", {"x"}, {numbers[1]})};
}

Value texcoord_of(NodeContext& context) {
    return context.input("texcoord", Type::vector2, uv_set(0));
}

// Order 0: scale, rotate, translate; order 1: translate, rotate, scale; both about the pivot. The
// scale divides, the rotation is clockwise and the offset is subtracted (NG_place2d_vector2).
Value place2d(NodeContext& context) {
    GraphBuilder& graph = context.graph();
    const Value uv = texcoord_of(context);
    const Numbers pivot = context.pair("pivot", 0), offset = context.pair("offset", 0);
    const Numbers given = context.pair("scale", 1);
    const Number rotation = graph.math("negate", {"x"}, {context.number("rotate", 0)});
    const double order = context.constant("operationorder", 0);
    if (context.failed()) return bad_value();
    const Numbers scale = each(graph, {{1}, {1}}, given, &GraphBuilder::divide);
    const Numbers none = {{0}, {0}}, one = {{1}, {1}};
    if (order == 1) {
        const Numbers start = each(graph, pivot, offset, &GraphBuilder::add);
        const Value moved = transformed_uv(graph, uv, one, {0}, negated(graph, start));
        const Value turned = transformed_uv(graph, moved, one, rotation, none);
        return transformed_uv(graph, turned, scale, {0}, pivot);
    }
    const Numbers end = each(graph, pivot, offset, &GraphBuilder::subtract);
    if (!are_literal(pivot) || !are_literal(scale) || !rotation.is_literal()) {
        const Value moved = transformed_uv(graph, uv, one, {0}, negated(graph, pivot));
        return transformed_uv(graph, moved, scale, rotation, end);
    }
    const Turn turn(rotation.value);
    const double u = pivot[0].value * scale[0].value, v = pivot[1].value * scale[1].value;
    const Numbers back = {{turn.x(u, v)}, {turn.y(u, v)}};
    return transformed_uv(graph, uv, scale, rotation,
                          each(graph, end, back, &GraphBuilder::subtract));
}

Value rotate2d(NodeContext& context) {
    const Value in = context.input("in", Type::vector2);
    const Number amount = context.number("amount", 0);
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    return transformed_uv(graph, in, {{1}, {1}}, graph.math("negate", {"x"}, {amount}), {{0}, {0}});
}

std::string wrap_of(NodeContext& context) {
    const std::string u = context.text("uaddressmode", "periodic");
    const std::string v = context.text("vaddressmode", "periodic");
    if (u != v)
        context.approximate("u and v have the address mode '" + u + "', instead of '" + v + "'");
    if (u == "constant")
        context.approximate("the border of the image is repeated instead of the default color");
    if (u == "clamp" || u == "constant") return "clamp";
    return u == "mirror" ? "mirror" : "repeat";
}

void lose_frames(NodeContext& context) {
    if (!context.text("layer", "").empty()) context.lose("the layer of the image is not read");
    if (!context.text("framerange", "").empty()) context.lose("one frame is read");
}

// A color that is stored with a gamma is decoded by a node, after the filter.
Value decoded(NodeContext& context, Value value, double gamma) {
    GraphBuilder& graph = context.graph();
    Value color = value;
    color.type = Type::color3;
    const Value linear =
        wire_value(Type::color3,
                   graph.add("color_gamma", "color",
                             {graph.input("color", color), graph.input("gamma", Number{gamma})}));
    if (size_of(value.type) == 3) return linear;
    Numbers parts;
    for (int i = 0; i < 3; ++i)
        parts.push_back(graph.part(linear, i));
    parts.push_back(graph.part(value, 3));
    return graph.from_parts(value.type, parts);
}

Value read_image(NodeContext& context, const Value& uv) {
    const Source file = context.importer().sources().input(context.key(), "file");
    if (file.input == no_element || file.kind == Source::Kind::bad ||
        file.kind == Source::Kind::node)
        return context.fail("reads no file", "a file");
    auto image = std::make_shared<ImageRead>();
    image->file = context.importer().image_path(file.input);
    if (image->file.empty()) return bad_value();
    ColorSpace space;
    if (is_color(context.type())) {
        const auto found = context.importer().color_space(file.input);
        if (!found) return bad_value();
        space = *found;
    }
    image->wrap = wrap_of(context);
    const std::string filter = context.text("filtertype", "linear");
    if (filter == "cubic") context.approximate("the filter is linear instead of cubic");
    image->filter = filter == "closest" ? "nearest" : "linear";
    lose_frames(context);
    if (context.failed()) return bad_value();
    image->image = image_value(*image, space.is_srgb() ? "srgb" : "linear", "srgb");
    image->change = uv.change;
    const Link link = context.graph().wire(uv);
    if (link != Link{"surface", "uv0"}) image->uv = link;
    image->id = context.element().name;
    Value value;
    value.type = context.type();
    value.image = image;
    return space.is_linear() || space.is_srgb() ? value : decoded(context, value, space.gamma);
}

Value image(NodeContext& context) {
    const Value uv = texcoord_of(context);
    return context.failed() ? bad_value() : read_image(context, uv);
}

// (texcoord uvtiling - uvoffset) realworldtilesize / realworldimagesize (NG_tiledimage)
Value tiled_image(NodeContext& context) {
    GraphBuilder& graph = context.graph();
    const Value uv = texcoord_of(context);
    const Numbers tiling = context.pair("uvtiling", 1), offset = context.pair("uvoffset", 0);
    const Numbers image_size = context.pair("realworldimagesize", 1);
    const Numbers tile_size = context.pair("realworldtilesize", 1);
    if (context.failed()) return bad_value();
    const Numbers factor = each(graph, tile_size, image_size, &GraphBuilder::divide);
    const Numbers moved = each(graph, offset, factor, &GraphBuilder::multiply);
    graph.begin(context.element().name + "_uv");
    const Value tiled =
        transformed_uv(graph, uv, each(graph, tiling, factor, &GraphBuilder::multiply), {0},
                       negated(graph, moved));
    graph.begin(context.element().name);
    return read_image(context, tiled);
}

// Numbers of a lattice that differ from MaterialX's, with its amplitude and pivot.
Value noise(NodeContext& context) {
    const bool is_flat = context.category().ends_with("2d");
    const bool is_fractal = context.category().starts_with("fractal");
    GraphBuilder& graph = context.graph();
    const Value point = is_flat ? texcoord_of(context)
                                : context.input("position", Type::vector3,
                                                wire_value(Type::vector3, {"surface", "position"}));
    const Value amplitude =
        context.input("amplitude", context.type(), NodeContext::filled(context.type(), 1), true);
    const Number pivot = context.number("pivot", 0);
    const double octaves = is_fractal ? context.constant("octaves", 3) : 1;
    const Number lacunarity = context.number("lacunarity", 2);
    const Number gain = context.number("diminish", 0.5);
    if (context.failed()) return bad_value();
    context.approximate("'" + std::string(context.category()) +
                        "' becomes gradient_noise, which has other random numbers");
    Numbers at = {graph.part(point, 0), graph.part(point, 1),
                  is_flat ? Number{0} : graph.part(point, 2)};
    const Value where = is_flat ? graph.from_parts(Type::vector3, at) : point;
    Numbers parts;
    for (int i = 0; i < context.size(); ++i) {
        const double used = std::clamp(octaves, 1.0, 8.0);
        std::vector<Input> inputs = {graph.input("point", where),
                                     graph.input("scale", Number{1}),
                                     graph.input("octaves", Number{used}),
                                     graph.input("lacunarity", lacunarity),
                                     graph.input("gain", gain),
                                     graph.input("seed", Number{0.0 + i})};
        const Number made{0, graph.add("gradient_noise", "value", std::move(inputs))};
        const Number factor = graph.part(amplitude, size_of(amplitude.type) == 1 ? 0 : i);
        parts.push_back(graph.add(graph.multiply(made, factor), pivot));
    }
    return graph.from_parts(context.type(), parts);
}

}  // namespace

json::Value image_value(const ImageRead& image, std::string_view encoding,
                        std::string_view default_encoding) {
    std::vector<std::pair<std::string, json::Value>> members = {
        {"file", json::Value::string(image.file)}};
    const auto add = [&](const char* key, std::string_view value, std::string_view otherwise) {
        if (value != otherwise) members.emplace_back(key, json::Value::string(value));
    };
    add("encoding", encoding, default_encoding);
    add("wrap", image.wrap, "repeat");
    add("filter", image.filter, "linear");
    return members.size() == 1 ? members[0].second : json::Value::object(members);
}

Value uv_set(int set) {
    Value value = wire_value(Type::vector2, {"surface", "uv" + std::to_string(set)});
    value.change = UvChange{set};
    return value;
}

Value transformed_uv(GraphBuilder& graph, const Value& uv, const Numbers& scale,
                     const Number& rotation, const Numbers& offset) {
    if (are(scale, 1) && are({rotation}, 0) && are(offset, 0)) return uv;
    std::vector<Input> inputs;
    if (uv.is_literal() || graph.wire(uv) != Link{"surface", "uv0"})
        inputs.push_back(graph.input("uv", uv));
    if (!are(scale, 1))
        inputs.push_back(graph.input("scale", graph.from_parts(Type::vector2, scale)));
    if (!are({rotation}, 0)) inputs.push_back(graph.input("rotation", rotation));
    if (!are(offset, 0))
        inputs.push_back(graph.input("offset", graph.from_parts(Type::vector2, offset)));
    Value value = wire_value(Type::vector2, graph.add("uv_transform", "uv", std::move(inputs)));
    if (!uv.change || !are_literal(scale) || !rotation.is_literal()) return value;
    const Turn turn(rotation.value);
    const auto& d = uv.change->derivative;
    const double u0 = d[0] * scale[0].value, u1 = d[1] * scale[0].value;
    const double v0 = d[2] * scale[1].value, v1 = d[3] * scale[1].value;
    value.change =
        UvChange{uv.change->set, {turn.x(u0, v0), turn.x(u1, v1), turn.y(u0, v0), turn.y(u1, v1)}};
    return value;
}

std::span<const HandlerRow> texture_handlers() {
    static constexpr std::array rows = {
        HandlerRow{"image", image},     HandlerRow{"tiledimage", tiled_image},
        HandlerRow{"place2d", place2d}, HandlerRow{"rotate2d", rotate2d},
        HandlerRow{"noise2d", noise},   HandlerRow{"noise3d", noise},
        HandlerRow{"fractal2d", noise}, HandlerRow{"fractal3d", noise},
    };
    return rows;
}

}  // namespace wrinkle::materialx
