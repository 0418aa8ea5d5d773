// Arithmetic by components: a node for all of a color where one exists, else one for each number.
#include <algorithm>
#include <functional>

#include "import/mtlx_importer.h"

namespace wrinkle::materialx {
namespace {

struct Operation {
    std::string_view category;
    const char* type;                 // for single numbers
    std::vector<const char*> ports;   // in the order of `inputs`
    std::vector<const char*> inputs;  // MaterialX inputs
    std::vector<double> defaults;
    const char* vector_type = nullptr;  // for three numbers
    std::vector<const char*> vector_ports = {};
};

const std::vector<Operation>& operations() {
    static const std::vector<Operation> table = {
        {"add", "add", {"a", "b"}, {"in1", "in2"}, {0, 0}, "vec3_add", {"a", "b"}},
        {"subtract", "subtract", {"a", "b"}, {"in1", "in2"}, {0, 0}, "vec3_subtract", {"a", "b"}},
        {"multiply", "multiply", {"a", "b"}, {"in1", "in2"}, {0, 1}, "vec3_multiply", {"a", "b"}},
        {"divide", "divide", {"a", "b"}, {"in1", "in2"}, {0, 1}},
        {"modulo", "modulo", {"x", "divisor"}, {"in1", "in2"}, {0, 1}},
        {"power", "power", {"base", "exponent"}, {"in1", "in2"}, {0, 1}},
        {"safepower", "safe_power", {"base", "exponent"}, {"in1", "in2"}, {0, 1}},
        {"min", "minimum", {"a", "b"}, {"in1", "in2"}, {0, 0}, "vec3_minimum", {"a", "b"}},
        {"max", "maximum", {"a", "b"}, {"in1", "in2"}, {0, 0}, "vec3_maximum", {"a", "b"}},
        {"atan2", "arctangent2", {"y", "x"}, {"iny", "inx"}, {0, 1}},
        {"absval", "absolute", {"x"}, {"in"}, {0}, "vec3_absolute", {"vector"}},
        {"floor", "floor", {"x"}, {"in"}, {0}, "vec3_floor", {"vector"}},
        {"fract", "fraction", {"x"}, {"in"}, {0}, "vec3_fraction", {"vector"}},
        {"ceil", "ceiling", {"x"}, {"in"}, {0}},
        {"round", "round", {"x"}, {"in"}, {0}},
        {"sign", "sign", {"x"}, {"in"}, {0}},
        {"sin", "sine", {"angle"}, {"in"}, {0}},
        {"cos", "cosine", {"angle"}, {"in"}, {0}},
        {"tan", "tangent", {"angle"}, {"in"}, {0}},
        {"asin", "arcsine", {"x"}, {"in"}, {0}},
        {"acos", "arccosine", {"x"}, {"in"}, {0}},
        {"sqrt", "square_root", {"x"}, {"in"}, {0}},
        {"ln", "logarithm", {"x"}, {"in"}, {1}},
        {"exp", "exponential", {"x"}, {"in"}, {0}},
        {"clamp", "clamp", {"x", "low", "high"}, {"in", "low", "high"}, {0, 0, 1}},
        {"remap",
         "remap",
         {"x", "from_low", "from_high", "to_low", "to_high"},
         {"in", "inlow", "inhigh", "outlow", "outhigh"},
         {0, 0, 1, 0, 1}},
        {"smoothstep", "smoothstep", {"x", "low", "high"}, {"in", "low", "high"}, {0, 0, 1}},
    };
    return table;
}

// Derivative of the uv that a sum or product with known numbers makes.
std::optional<UvChange> changed_uv(const Operation& operation, const std::vector<Value>& values) {
    if (values.size() != 2) return {};
    const bool is_first = values[0].change.has_value();
    const Value& uv = values[is_first ? 0 : 1];
    const Value& other = values[is_first ? 1 : 0];
    if (!uv.change || !other.is_literal()) return {};
    UvChange change = *uv.change;
    const std::string_view category = operation.category;
    if (category == "add" || (category == "subtract" && is_first)) return change;
    const bool divides = category == "divide" && is_first;
    if (category != "multiply" && !divides) return {};
    for (size_t i = 0; i < 4; ++i) {
        const double factor = other.literal(size_of(other.type) == 1 ? 0 : static_cast<int>(i) / 2);
        if (divides && factor == 0) return {};
        change.derivative[i] =
            divides ? change.derivative[i] / factor : change.derivative[i] * factor;
    }
    return change;
}

Value as_vector(NodeContext& context, const Operation& operation, std::vector<Value>& values) {
    std::vector<Input> inputs;
    for (size_t i = 0; i < values.size(); ++i) {
        Value value = values[i];
        if (size_of(value.type) == 1) {
            const Number number = context.graph().part(value, 0);
            value = context.graph().from_parts(context.type(), {number, number, number});
        }
        inputs.push_back(context.graph().input(operation.vector_ports[i], value));
    }
    return wire_value(context.type(),
                      context.graph().add(operation.vector_type, "vector", std::move(inputs)));
}

Value by_components(NodeContext& context, const Operation& operation,
                    const std::vector<Value>& values) {
    Numbers results;
    for (int i = 0; i < context.size(); ++i) {
        Numbers numbers;
        for (const Value& value : values)
            numbers.push_back(context.graph().part(value, size_of(value.type) == 1 ? 0 : i));
        results.push_back(context.graph().math(operation.type, operation.ports, numbers));
    }
    return context.graph().from_parts(context.type(), results);
}

Value operate(NodeContext& context) {
    const auto operation =
        std::ranges::find(operations(), context.category(), &Operation::category);
    if (context.size() == 0) return context.fail("has no type of numbers");
    std::vector<Value> values;
    bool is_single = context.size() == 1;
    for (size_t i = 0; i < operation->inputs.size(); ++i) {
        const Value otherwise = NodeContext::filled(context.type(), operation->defaults[i]);
        values.push_back(context.input(operation->inputs[i], context.type(), otherwise, true));
    }
    if (context.failed()) return bad_value();
    is_single = is_single || std::ranges::all_of(values, &Value::is_literal);
    if (operation->vector_type && context.size() == 3 && !is_single)
        return as_vector(context, *operation, values);
    Value made = by_components(context, *operation, values);
    made.change = changed_uv(*operation, values);
    return made;
}

Value mix(NodeContext& context) {
    const Type type = context.type();
    Value bg = context.any("bg", type, NodeContext::zero(type));
    Value fg = context.any("fg", type, NodeContext::zero(type));
    const Value mask = context.input("mix", type, NodeContext::zero(Type::float_), true);
    if (bg.is_bad || fg.is_bad || context.failed()) return bad_value();
    if ((bg.bump || bg.is_surface_normal) && (fg.bump || fg.is_surface_normal))
        return mix_normals(context, bg, fg, mask);
    bg = context.input("bg", type);
    fg = context.input("fg", type);
    if (context.failed()) return bad_value();
    GraphBuilder& graph = context.graph();
    if (context.size() == 3 && size_of(mask.type) == 1)
        return wire_value(type, graph.add("vec3_mix", "vector",
                                          {graph.input("a", bg), graph.input("b", fg),
                                           graph.input("mask", graph.part(mask, 0))}));
    Numbers results;
    for (int i = 0; i < context.size(); ++i)
        results.push_back(graph.math("mix", {"a", "b", "mask"},
                                     {graph.part(bg, i), graph.part(fg, i),
                                      graph.part(mask, size_of(mask.type) == 1 ? 0 : i)}));
    return graph.from_parts(type, results);
}

// amount - in
Value invert(NodeContext& context) {
    const Value in = context.input("in", context.type());
    const Value amount =
        context.input("amount", context.type(), NodeContext::filled(context.type(), 1), true);
    if (context.failed()) return bad_value();
    static const Operation* subtract = &operations()[1];
    std::vector<Value> values = {amount, in};
    if (context.size() == 3 && !in.is_literal()) return as_vector(context, *subtract, values);
    return by_components(context, *subtract, values);
}

// (in - pivot) amount + pivot
Value contrast(NodeContext& context) {
    const Type type = context.type();
    const Value in = context.input("in", type);
    const Value amount = context.input("amount", type, NodeContext::filled(type, 1), true);
    const Value pivot = context.input("pivot", type, NodeContext::filled(type, 0.5), true);
    GraphBuilder& graph = context.graph();
    const auto part = [&](const Value& value, int i) {
        return graph.part(value, size_of(value.type) == 1 ? 0 : i);
    };
    Numbers results;
    for (int i = 0; i < context.size() && !context.failed(); ++i) {
        const Number scaled =
            graph.multiply(graph.subtract(part(in, i), part(pivot, i)), part(amount, i));
        results.push_back(graph.add(scaled, part(pivot, i)));
    }
    return graph.from_parts(type, results);
}

// Without a clamp the range is extrapolated linearly; a gamma needs a clamp.
Value range(NodeContext& context) {
    const bool is_clamped = context.text("doclamp", "false") == "true";
    Numbers results;
    std::vector<Value> values;
    for (const auto& [name, otherwise] : {std::pair{"in", 0.0},
                                          {"inlow", 0.0},
                                          {"inhigh", 1.0},
                                          {"gamma", 1.0},
                                          {"outlow", 0.0},
                                          {"outhigh", 1.0}})
        values.push_back(context.input(name, context.type(),
                                       NodeContext::filled(context.type(), otherwise), true));
    if (context.failed()) return bad_value();
    const bool is_straight = values[3].is_literal() && values[3].literal(0) == 1;
    if (!is_straight && !is_clamped) context.approximate("a range with a gamma is clamped");
    GraphBuilder& graph = context.graph();
    for (int i = 0; i < context.size(); ++i) {
        Numbers numbers;
        for (const Value& value : values)
            numbers.push_back(graph.part(value, size_of(value.type) == 1 ? 0 : i));
        if (!is_straight || is_clamped) {
            std::vector<Input> inputs;
            constexpr std::array ports = {"value", "in_low",  "in_high",
                                          "gamma", "out_low", "out_high"};
            for (size_t port = 0; port < ports.size(); ++port)
                inputs.push_back(graph.input(ports[port], numbers[port]));
            results.push_back({0, graph.add("levels", "value", std::move(inputs))});
            continue;
        }
        numbers.erase(numbers.begin() + 3);
        results.push_back(
            graph.math("remap", {"x", "from_low", "from_high", "to_low", "to_high"}, numbers));
    }
    return graph.from_parts(context.type(), results);
}

Value compare(NodeContext& context) {
    const Value first = context.input("value1", Type::float_, NodeContext::filled(Type::float_, 1));
    const Value second = context.input("value2", Type::float_);
    const Value yes = context.input("in1", context.type());
    const Value no = context.input("in2", context.type());
    if (context.failed()) return bad_value();
    const char* comparison = context.category() == "ifgreater"     ? "greater"
                             : context.category() == "ifgreatereq" ? "greater_equal"
                                                                   : "equal";
    GraphBuilder& graph = context.graph();
    Numbers results;
    for (int i = 0; i < context.size(); ++i)
        results.push_back(
            {0,
             graph.add(
                 "compare", "result",
                 {graph.input("a", graph.part(first, 0)), graph.input("b", graph.part(second, 0)),
                  literal_input("comparison", json::Value::string(comparison)),
                  graph.input("yes", graph.part(yes, i)), graph.input("no", graph.part(no, i))})});
    return graph.from_parts(context.type(), results);
}

}  // namespace

std::span<const HandlerRow> math_handlers() {
    static const std::vector<HandlerRow> rows = [] {
        std::vector<HandlerRow> made = {
            {"mix", mix},         {"invert", invert},     {"contrast", contrast},
            {"range", range},     {"ifgreater", compare}, {"ifgreatereq", compare},
            {"ifequal", compare},
        };
        for (const Operation& operation : operations())
            made.push_back({operation.category, operate});
        return made;
    }();
    return rows;
}

}  // namespace wrinkle::materialx
