// Literals of a graph file: the value of a JSON literal at a port, and its problems.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "json/value.h"
#include "registry/registry.h"

namespace wrinkle {

std::string one_of(std::span<const std::string> names);  // "a, b or c"

// Stores the numbers of a float, vector, color (an array, linear, or "#rrggbb", sRGB-coded), height
// or normal; returns false if `value` is not a valid one.
bool literal_numbers(const json::Value& value, PortType type, std::array<double, 4>& numbers);

// Returns the index of a choice, the value of a count, 0 or 1 of a flag; std::nullopt if `value` is
// not a valid one.
std::optional<int32_t> literal_option(const json::Value& value, const Port& port);

// An image as a path or as {"file", "encoding", "wrap", "filter"}.
struct ImageLiteral {
    std::string_view file;             // valid as long as the value's tree
    std::optional<Encoding> encoding;  // std::nullopt: that of the port
    Wrap wrap = Wrap::repeat;
    Filter filter = Filter::linear;
};
ImageLiteral literal_image(const json::Value& value);  // reads valid members only

struct LiteralProblem {
    RuleId rule;
    json::Value where;
    std::string message;  // a predicate: "holds a string"
    std::string expected;
    Severity severity = Severity::error;
};
// Returns all problems of a literal at a port, except those of files.
std::vector<LiteralProblem> literal_problems(const json::Value& value, const Port& port);

}  // namespace wrinkle
