// Literals of a graph file: what a JSON value at a port means, and what is wrong with it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "json/value.h"
#include "registry/registry.h"

namespace wrinkle {

// The numbers of a float, vector, color, height or normal; false when the value is none.
bool literal_numbers(const json::Value& value, PortType type, std::array<double, 4>& numbers);

// The index of a choice, the value of a count, 0 or 1 of a flag; nothing when the value is none.
std::optional<int32_t> literal_option(const json::Value& value, const Port& port);

// An image as a path or as {"file", "encoding", "wrap", "filter"}.
struct ImageLiteral {
    std::string_view file;             // lives as long as the value's tree
    std::optional<Encoding> encoding;  // nothing: that of the port
    Wrap wrap = Wrap::repeat;
    Filter filter = Filter::linear;
};
ImageLiteral literal_image(const json::Value& value);  // of what is valid in it

struct LiteralProblem {
    json::Value where;
    Severity severity = Severity::error;
    std::string message;  // a predicate: "holds a string"
    std::string expected;
};
// Everything that is wrong with a literal at a port, files aside.
std::vector<LiteralProblem> literal_problems(const json::Value& value, const Port& port);

}  // namespace wrinkle
