// Normal maps and bumps. Their values are gradients; a shader resolves them.
#include <cmath>

#include "import/mtlx_texture.h"

namespace wrinkle::materialx {
namespace {

Value bump_value(const Link& gradient) {
    Value value;
    value.type = Type::vector3;
    value.bump = gradient;
    return value;
}

// A node tangent_normal_map reads slopes along the directions of its uv. They are those of uv0, as
// a normalmap has them, if the uv is uv0 made larger by one factor.
bool has_directions_of_uv0(const ImageRead& image) {
    if (!image.change) return false;
    const auto& d = image.change->derivative;
    return image.change->set == 0 && d[0] > 0 && d[0] == d[3] && d[1] == 0 && d[2] == 0;
}

Link from_image(NodeContext& context, const ImageRead& image, const Number& strength) {
    GraphBuilder& graph = context.graph();
    std::vector<Input> inputs = {
        literal_input("image", image_value(image, "normal_gl", "normal_gl"))};
    if (image.uv) inputs.push_back(wire_input("uv", *image.uv));
    if (strength.link || strength.value != 1) inputs.push_back(graph.input("strength", strength));
    return graph.add("tangent_normal_map", "gradient", std::move(inputs));
}

// 2 in - 1. A factor of x and y is one of the slopes.
Link from_numbers(NodeContext& context, const Value& in, const Numbers& scale) {
    GraphBuilder& graph = context.graph();
    const bool is_single = scale.size() == 1;
    Value normal;
    if (is_single && !in.is_literal()) {
        const Link doubled = graph.add(
            "vec3_scale", "vector", {graph.input("vector", in), graph.input("factor", Number{2})});
        const Value one = literal_value(Type::vector3, {1, 1, 1});
        normal =
            wire_value(Type::vector3, graph.add("vec3_subtract", "vector",
                                                {wire_input("a", doubled), graph.input("b", one)}));
    } else {
        Numbers parts;
        for (int i = 0; i < 3; ++i) {
            const Number part = graph.subtract(graph.multiply(graph.part(in, i), {2}), {1});
            const bool is_scaled = !is_single && i < 2;
            parts.push_back(is_scaled ? graph.multiply(part, scale[static_cast<size_t>(i)]) : part);
        }
        normal = graph.from_parts(Type::vector3, parts);
    }
    std::vector<Input> inputs = {graph.input("normal", normal)};
    if (is_single && (scale[0].link || scale[0].value != 1))
        inputs.push_back(graph.input("strength", scale[0]));
    return graph.add("gradient_from_tangent_normal", "gradient", std::move(inputs));
}

// Only the mesh's own frame; a bump below is added.
std::optional<Link> over_base(NodeContext& context, const Link& bump) {
    const Value base = context.any("normal", Type::vector3, NodeContext::zero(Type::vector3));
    for (const char* name : {"tangent", "bitangent"}) {
        if (!context.has(name)) continue;
        const Value value = context.input(name, Type::vector3);
        if (value.text != name) {
            context.fail("input '" + std::string(name) + "' is not the mesh's",
                         "the node '" + std::string(name) + "'");
            return {};
        }
    }
    if (!context.has("normal") || base.is_surface_normal) return bump;
    if (!base.bump) {
        if (!base.is_bad)
            context.fail("input 'normal' is not a normal map", "another normalmap or bump");
        return {};
    }
    context.approximate(
        "the slopes of both normal maps are added; MaterialX turns the second by "
        "the first");
    GraphBuilder& graph = context.graph();
    return graph.add("gradient_add", "gradient",
                     {wire_input("a", *base.bump), wire_input("b", bump)});
}

Value finished(NodeContext& context, const Link& bump) {
    if (context.failed()) return bad_value();
    const auto sum = over_base(context, bump);
    return sum && !context.failed() ? bump_value(*sum) : bad_value();
}

Value normal_map(NodeContext& context) {
    GraphBuilder& graph = context.graph();
    const Value in = context.any("in", Type::vector3, literal_value(Type::vector3, {0.5, 0.5, 1}));
    const Value scale =
        context.input("scale", Type::vector2, NodeContext::filled(Type::float_, 1), true);
    if (in.is_bad || context.failed()) return bad_value();
    if (context.text("space", "tangent") == "object")
        return context.fail("reads a map of object space", "a tangent-space map");
    const bool is_single = size_of(scale.type) == 1;
    const Number x = graph.part(scale, 0);
    if (in.is_encoded_bump) {
        if (!is_single) return context.fail("scales u and v of a bump apart", "one number");
        if (x.is_literal() && x.value == 1) return finished(context, *in.bump);
        return finished(context,
                        graph.add("gradient_scale", "gradient",
                                  {wire_input("gradient", *in.bump), graph.input("amount", x)}));
    }
    if (in.bump || in.is_surface_normal)
        return context.fail("input 'in' is a normal already", "a normal map from 0 to 1");
    if (in.image && is_single && has_directions_of_uv0(*in.image))
        return finished(context, from_image(context, *in.image, x));
    const Numbers factors = is_single ? Numbers{x} : Numbers{x, graph.part(scale, 1)};
    return finished(context, from_numbers(context, in, factors));
}

// Slopes are dh/du / 16 of the uv set (mx_heighttonormal_vector3). The node height_map gives
// dh/du / sqrt(|det|) of its uv, det its change of area.
Link gradient_of(NodeContext& context, const Value& height, const Number& scale) {
    GraphBuilder& graph = context.graph();
    const Number factor = graph.multiply(scale, {1.0 / 16});
    const auto image = height.image;
    if (!image || !image->change || image->change->set != 0) {
        context.approximate(
            "the slope of the height is taken along the surface, not per unit of "
            "uv");
        const Number value = graph.multiply(graph.part(height, 0), factor);
        return graph.add("gradient_from_height", "gradient", {graph.input("height", value)});
    }
    const double area = std::sqrt(std::abs(image->change->area()));
    std::vector<Input> inputs = {literal_input("image", image_value(*image, "linear", "linear"))};
    if (image->uv) inputs.push_back(wire_input("uv", *image->uv));
    inputs.push_back(graph.input("amplitude", graph.multiply(factor, {area})));
    inputs.push_back(literal_input("scale", json::Value::string("unit")));
    return graph.add("height_map", "gradient", std::move(inputs));
}

Value height_to_normal(NodeContext& context) {
    const Value height = context.input("in", Type::float_);
    const Number scale = context.number("scale", 1);
    const Value uv = context.input("texcoord", Type::vector2, uv_set(0));
    if (context.failed()) return bad_value();
    const bool is_uv0 =
        uv.change && uv.change->set == 0 && uv.change->derivative == UvChange{}.derivative;
    if (!is_uv0) return context.fail("input 'texcoord' is not the first uv set", "texcoord");
    Value value = bump_value(gradient_of(context, height, scale));
    value.is_encoded_bump = true;
    return value;
}

Value bump(NodeContext& context) {
    const Value height = context.input("height", Type::float_);
    const Number scale = context.number("scale", 1);
    if (context.failed()) return bad_value();
    return finished(context, gradient_of(context, height, scale));
}

Link gradient_or_flat(NodeContext& context, const Value& normal) {
    if (normal.bump) return *normal.bump;
    return context.graph().add("gradient_from_height", "gradient", {});
}

}  // namespace

Value mix_normals(NodeContext& context, const Value& bg, const Value& fg, const Value& mask) {
    if (size_of(mask.type) != 1) return context.fail("mixes normals by a vector", "one number");
    if (bg.is_surface_normal && fg.is_surface_normal) return bg;
    context.approximate("slopes are mixed instead of normals");
    GraphBuilder& graph = context.graph();
    Value value = bump_value(graph.add("gradient_mix", "gradient",
                                       {wire_input("a", gradient_or_flat(context, bg)),
                                        wire_input("b", gradient_or_flat(context, fg)),
                                        graph.input("mask", graph.part(mask, 0))}));
    value.is_encoded_bump = bg.is_encoded_bump && fg.is_encoded_bump;
    return value;
}

std::span<const HandlerRow> bump_handlers() {
    static constexpr std::array rows = {
        HandlerRow{"normalmap", normal_map},
        HandlerRow{"heighttonormal", height_to_normal},
        HandlerRow{"bump", bump},
    };
    return rows;
}

}  // namespace wrinkle::materialx
