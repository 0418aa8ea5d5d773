// The condition under which a graph input is displayed: "input.NAME", "!input.NAME", or
// "input.NAME OP VALUE" with OP one of == != < <= > >= and VALUE a number, true, false or the name
// of a choice. "input.NAME" holds for a value other than false and 0. A condition has no effect on
// the material.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wrinkle {

struct Condition {
    std::string input;
    std::string op;     // "!=" for "input.NAME", "==" for "!input.NAME"
    std::string value;  // "" for these two
};

// Returns std::nullopt if the text is not a condition.
std::optional<Condition> parse_condition(std::string_view text);

}  // namespace wrinkle
