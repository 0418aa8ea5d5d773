#include "import/mtlx_interface.h"

#include <cmath>

namespace wrinkle::materialx {
namespace {

struct ExposedType {
    Type type;
    const char* name;
};

constexpr std::array exposed_types = {
    ExposedType{Type::float_, "float"}, ExposedType{Type::color3, "color"},
    ExposedType{Type::vector2, "vec2"}, ExposedType{Type::vector3, "vec3"},
    ExposedType{Type::vector4, "vec4"}, ExposedType{Type::color4, "vec4"},
};

const char* exposed_type(Type type) {
    for (const ExposedType& row : exposed_types)
        if (row.type == type) return row.name;
    return nullptr;
}

json::Value json_of(const Value& value) {
    std::vector<json::Value> numbers;
    for (int i = 0; i < size_of(value.type); ++i)
        numbers.push_back(json::Value::number(value.literal(i)));
    return numbers.size() == 1 ? numbers[0] : json::Value::array(numbers);
}

// Returns the range that two attributes give by their first numbers; null without both.
json::Value range(const Element& input, const char* low, const char* high) {
    const Type type = type_named(input.attribute("type"));
    if (!input.has(low) || !input.has(high)) return {};
    const auto least = parse_value(type, input.attribute(low));
    const auto most = parse_value(type, input.attribute(high));
    if (!least || !most || !(least->literal(0) < most->literal(0))) return {};
    const json::Value pair[] = {json::Value::number(least->literal(0)),
                                json::Value::number(most->literal(0))};
    return json::Value::array(pair);
}

}  // namespace

bool is_exposable(Type type) {
    return exposed_type(type) != nullptr;
}

GraphInput interface_input(const Element& input, const Value& value) {
    GraphInput made;
    made.name = input.name;
    made.type = exposed_type(value.type);
    made.default_value = json_of(value);
    made.slider = range(input, "uisoftmin", "uisoftmax");
    if (made.slider.is(json::Kind::null)) made.slider = range(input, "uimin", "uimax");
    made.label = input.attribute("uiname");
    made.group = input.attribute("uifolder");
    made.doc = input.attribute("doc");
    return made;
}

GraphInput output_input(const StandardOutput& output, const Value& value) {
    GraphInput made;
    made.name = output.name;
    made.type = output.type == "height" ? "height" : size_of(value.type) == 1 ? "float" : "color";
    made.default_value = json_of(value);
    if (output.slider_high > output.low && std::isfinite(output.low)) {
        const json::Value pair[] = {json::Value::number(output.low),
                                    json::Value::number(output.slider_high)};
        made.slider = json::Value::array(pair);
    }
    made.doc = output.doc;
    return made;
}

}  // namespace wrinkle::materialx
