// Properties of the surface, in object space.
#include "import/mtlx_texture.h"

namespace wrinkle::materialx {
namespace {

Value texcoord(NodeContext& context) {
    const double index = context.constant("index", 0);
    if (index < 0 || index > 3) return context.fail("uv set above 3", "index 0 to 3");
    return uv_set(static_cast<int>(index));
}

// An object that is not moved has the same position in both spaces.
void note_space(NodeContext& context) {
    if (context.text("space", "object") == "world")
        context.approximate("is read in object space instead of world space");
}

Value position(NodeContext& context) {
    note_space(context);
    return wire_value(Type::vector3, {"surface", "position"});
}

Value normal(NodeContext&) {
    Value value;
    value.type = Type::vector3;
    value.is_surface_normal = true;
    return value;
}

Value tangent(NodeContext& context) {
    GraphBuilder& graph = context.graph();
    const char* output = context.category() == "tangent" ? "tangent" : "bitangent";
    Value value = wire_value(Type::vector3, graph.add("tangent_frame", output, {}));
    value.text = output;
    return value;
}

Value geom_color(NodeContext& context) {
    GraphBuilder& graph = context.graph();
    const Value color = wire_value(Type::color4, {"surface", "color0"});
    if (context.constant("index", 0) != 0) return context.fail("vertex color above 0", "index 0");
    if (context.size() == 4) return color;
    Numbers parts;
    for (int i = 0; i < context.size(); ++i)
        parts.push_back(graph.part(color, i));
    return graph.from_parts(context.type(), parts);
}

Value primitive_variable(NodeContext& context) {
    const std::string name = context.text("geomprop", "");
    if (context.type() == Type::vector2 && (name == "st" || name == "uv" || name == "UV0"))
        return uv_set(0);
    if (context.type() == Type::vector2 && (name == "st1" || name == "uv1" || name == "UV1"))
        return uv_set(1);
    return context.fail("the geometry property '" + name + "' is not supported", "st or st1");
}

}  // namespace

std::span<const HandlerRow> surface_handlers() {
    static constexpr std::array rows = {
        HandlerRow{"texcoord", texcoord},
        HandlerRow{"position", position},
        HandlerRow{"normal", normal},
        HandlerRow{"tangent", tangent},
        HandlerRow{"bitangent", tangent},
        HandlerRow{"geomcolor", geom_color},
        HandlerRow{"geompropvalue", primitive_variable},
    };
    return rows;
}

}  // namespace wrinkle::materialx
