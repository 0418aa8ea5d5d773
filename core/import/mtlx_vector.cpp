// Nodes that take values apart, put them together, or read all numbers of a vector.
#include <algorithm>
#include <cmath>

#include "import/mtlx_importer.h"

namespace wrinkle::materialx {
namespace {

Value constant(NodeContext& context) {
    return context.input("value", context.type());
}

Value dot(NodeContext& context) {
    return context.any("in", context.type(), NodeContext::zero(context.type()));
}

Value combine(NodeContext& context) {
    GraphBuilder& graph = context.graph();
    Numbers parts;
    for (const char* name : {"in1", "in2", "in3", "in4"}) {
        const auto source = context.importer().sources().input(context.key(), name);
        const bool is_rest = parts.size() >= static_cast<size_t>(context.size());
        if (is_rest) break;
        // combine2 also joins a color3 and an alpha, or two vector2.
        const Type type = source.kind == Source::Kind::absent
                              ? Type::float_
                              : type_named(context.importer()
                                               .document()[context.importer().document().child(
                                                   context.key().element, name)]
                                               .attribute("type"));
        const Value value = context.input(name, type == Type::none ? Type::float_ : type);
        for (int i = 0; i < size_of(value.type); ++i)
            parts.push_back(graph.part(value, i));
    }
    if (context.failed()) return bad_value();
    if (parts.size() != static_cast<size_t>(context.size()))
        return context.fail("combines " + std::to_string(parts.size()) + " numbers to a " +
                            std::string(name_of(context.type())));
    return graph.from_parts(context.type(), parts);
}

// The type of an input as it is written; `otherwise` without one.
Type input_type(NodeContext& context, std::string_view name, Type otherwise) {
    const Document& document = context.importer().document();
    const uint32_t input = document.child(context.key().element, name);
    if (input == no_element) return otherwise;
    const Type type = type_named(document[input].attribute("type"));
    return type == Type::none ? otherwise : type;
}

Value separate(NodeContext& context) {
    constexpr std::array types = {Type::vector2, Type::vector3, Type::vector4};
    const int size = context.category().back() - '0';
    return context.input("in", input_type(context, "in", types[static_cast<size_t>(size - 2)]));
}

Value extract(NodeContext& context) {
    const Value in = context.input("in", input_type(context, "in", Type::vector4));
    const double index = context.constant("index", 0);
    if (context.failed()) return bad_value();
    if (index < 0 || index >= size_of(in.type))
        return context.fail("index " + std::to_string(static_cast<int>(index)) + " is beyond a " +
                            std::string(name_of(in.type)));
    Value part;
    part.type = Type::float_;
    part.parts[0] = context.graph().part(in, static_cast<int>(index));
    if (index == 0) part.image = in.image;
    return part;
}

Value swizzle(NodeContext& context) {
    const Value in = context.input("in", input_type(context, "in", Type::vector4));
    const std::string channels = context.text("channels", "");
    if (context.failed()) return bad_value();
    Numbers parts;
    for (const char channel : channels) {
        const size_t index = std::string_view("xyzwrgba").find(channel);
        if (channel == '0' || channel == '1')
            parts.push_back({channel == '1' ? 1.0 : 0.0});
        else if (index != std::string_view::npos &&
                 static_cast<int>(index % 4) < std::max(1, size_of(in.type)))
            parts.push_back(context.graph().part(in, static_cast<int>(index % 4)));
        else
            return context.fail("channels '" + channels + "' are not those of a " +
                                std::string(name_of(in.type)));
    }
    if (static_cast<int>(parts.size()) != context.size())
        return context.fail("channels '" + channels + "' make no " +
                            std::string(name_of(context.type())));
    return context.graph().from_parts(context.type(), parts);
}

// A number fills a vector; a longer vector gets 1 for its alpha, a shorter one loses numbers.
Value convert(NodeContext& context) {
    const Type from = input_type(context, "in", Type::float_);
    Value in = context.any("in", from, NodeContext::zero(from));
    if (in.is_bad) return in;
    if (size_of(from) == context.size()) {
        in.type = context.type();
        return in;
    }
    in = context.input("in", from);
    if (context.failed()) return bad_value();
    Numbers parts;
    for (int i = 0; i < context.size(); ++i) {
        const bool is_given = size_of(from) == 1 || i < size_of(from);
        parts.push_back(is_given ? context.graph().part(in, size_of(from) == 1 ? 0 : i)
                                 : Number{i == 3 ? 1.0 : 0.0});
    }
    return context.graph().from_parts(context.type(), parts);
}

Value number_of(NodeContext& context, const Number& number) {
    Value value;
    value.type = context.type() == Type::none ? Type::float_ : context.type();
    value.parts[0] = number;
    return value;
}

Number sum_of_products(GraphBuilder& graph, const Value& a, const Value& b) {
    Number sum;
    for (int i = 0; i < size_of(a.type); ++i)
        sum = graph.add(sum, graph.multiply(graph.part(a, i), graph.part(b, i)));
    return sum;
}

Value dot_product(NodeContext& context) {
    const Type type = input_type(context, "in1", Type::vector3);
    const Value a = context.input("in1", type), b = context.input("in2", type);
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    if (size_of(type) == 3)
        return number_of(
            context, {0, graph.add("dot", "result", {graph.input("a", a), graph.input("b", b)})});
    return number_of(context, sum_of_products(graph, a, b));
}

Value cross_product(NodeContext& context) {
    const Value a = context.input("in1", Type::vector3), b = context.input("in2", Type::vector3);
    GraphBuilder& graph = context.graph();
    return wire_value(Type::vector3,
                      graph.add("cross", "vector", {graph.input("a", a), graph.input("b", b)}));
}

Value magnitude(NodeContext& context) {
    const Value in = context.input("in", input_type(context, "in", Type::vector3));
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    return number_of(context, graph.math("square_root", {"x"}, {sum_of_products(graph, in, in)}));
}

Value normalize(NodeContext& context) {
    const Type type = context.type();
    const Value given = context.any("in", type, NodeContext::zero(type));
    if (given.bump || given.is_surface_normal) return given;  // is a unit vector
    const Value in = context.input("in", type);
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    if (context.size() == 3)
        return wire_value(type, graph.add("normalize", "vector", {graph.input("vector", in)}));
    const Number length = graph.math("square_root", {"x"}, {sum_of_products(graph, in, in)});
    Numbers parts;
    for (int i = 0; i < context.size(); ++i)
        parts.push_back(graph.divide(graph.part(in, i), length));
    return graph.from_parts(type, parts);
}

Value rotate3d(NodeContext& context) {
    const Value in = context.input("in", Type::vector3);
    const Value axis =
        context.input("axis", Type::vector3, literal_value(Type::vector3, {0, 1, 0}));
    const Number amount = context.number("amount", 0);
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    // Its matrix turns clockwise, seen against the axis.
    return wire_value(Type::vector3,
                      graph.add("rotate", "vector",
                                {graph.input("vector", in), graph.input("axis", axis),
                                 graph.input("angle", graph.math("negate", {"x"}, {amount}))}));
}

}  // namespace

std::span<const HandlerRow> vector_handlers() {
    static constexpr std::array rows = {
        HandlerRow{"constant", constant},
        HandlerRow{"dot", dot},
        HandlerRow{"combine2", combine},
        HandlerRow{"combine3", combine},
        HandlerRow{"combine4", combine},
        HandlerRow{"separate2", separate},
        HandlerRow{"separate3", separate},
        HandlerRow{"separate4", separate},
        HandlerRow{"extract", extract},
        HandlerRow{"swizzle", swizzle},
        HandlerRow{"convert", convert},
        HandlerRow{"dotproduct", dot_product},
        HandlerRow{"crossproduct", cross_product},
        HandlerRow{"magnitude", magnitude},
        HandlerRow{"normalize", normalize},
        HandlerRow{"rotate3d", rotate3d},
    };
    return rows;
}

}  // namespace wrinkle::materialx
