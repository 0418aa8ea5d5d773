// Values of a MaterialX document on their way into a graph: numbers, wires of nodes that exist
// already, and reads of images for which no node exists yet.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "graph/document.h"

namespace wrinkle::materialx {

enum class Type : uint8_t {
    none,
    float_,
    integer,
    boolean,
    color3,
    color4,
    vector2,
    vector3,
    vector4,
    string,
    filename,
    shader,  // surfaceshader, displacementshader, material
};

Type type_named(std::string_view name);  // Type::none for other names
std::string_view name_of(Type type);     // "color3"
int size_of(Type type);                  // numbers in a value: 0 to 4
inline bool is_color(Type type) {
    return type == Type::color3 || type == Type::color4;
}

// A number, or the output of a node or an exposed input that has it.
struct Number {
    double value = 0;
    std::optional<Link> link = {};

    bool is_literal() const { return !link; }
};

// Jacobian of a uv by the uv set `set` (s, t) of the mesh: {du/ds, du/dt, dv/ds, dv/dt}.
struct UvChange {
    int set = 0;
    std::array<double, 4> derivative = {1, 0, 0, 1};

    double area() const { return derivative[0] * derivative[3] - derivative[1] * derivative[2]; }
};

// Reads an image at a uv. The node exists from the first use of the colors on.
struct ImageRead {
    json::Value image;  // value of an image port, with the encoding of the type
    std::string file;   // as in the graph
    std::string wrap = "repeat", filter = "linear";
    std::optional<Link> uv;          // absent: uv0
    std::optional<UvChange> change;  // absent if the uv is not linear
    std::string id;                  // id of the node to be made
    bool is_made = false;
};

struct Value {
    Type type = Type::none;
    std::optional<Link> whole;  // wire of two or more components; of one, see parts
    std::array<std::optional<Number>, 4> parts;  // single numbers, as far as they are known
    std::string text;                            // a string or filename
    std::shared_ptr<ImageRead> image;            // the value is this image, unchanged
    std::optional<Link> bump;                    // a normal: its gradient on the surface's normal
    bool is_surface_normal = false;              // a normal: the surface's own
    std::optional<UvChange> change;              // for a vector2
    bool is_encoded_bump = false;  // a tangent-space normal 0 to 1: `bump` is its gradient
    bool is_bad = false;           // an error is reported

    bool is_literal() const;
    double literal(int part) const { return parts[static_cast<size_t>(part)]->value; }
};

Value bad_value();
Value literal_value(Type type, const std::vector<double>& numbers);
Value wire_value(Type type, Link link);

// Parses the text of a `value` attribute; std::nullopt for another text. "true" is 1. Numbers are
// finite and within a float's range.
std::optional<Value> parse_value(Type type, std::string_view text);

}  // namespace wrinkle::materialx
