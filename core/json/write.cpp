#include "json/write.h"

namespace wrinkle::json {
namespace {

std::string scalar(const Value& value) {
    if (value.is(Kind::string)) return json_quoted(value.as_string());
    if (value.is(Kind::number)) return std::string(value.spelling());
    if (value.is(Kind::boolean)) return value.as_boolean() ? "true" : "false";
    return "null";
}

// Appends the value on one line. Stops after the first child that makes `out` longer than `width`.
void append_line(std::string& out, const Value& value, size_t width) {
    const bool object = value.is(Kind::object);
    if (!object && !value.is(Kind::array)) {
        out += scalar(value);
        return;
    }
    out += object ? '{' : '[';
    const char* separator = object ? " " : "";
    for (const Member& child : value.children()) {
        if (out.size() > width) return;
        out += separator;
        separator = ", ";
        if (object) out += json_quoted(child.key) + ": ";
        append_line(out, child.value, width);
    }
    out += !object ? "]" : value.size() > 0 ? " }" : "}";
}

}  // namespace

std::string one_line(const Value& value) {
    std::string text;
    append_line(text, value, text.max_size());
    return text;
}

std::string pretty(const Value& value, size_t indent, size_t column, size_t width) {
    std::string text;
    append_line(text, value, width);
    if (value.size() == 0 || column + text.size() < width) return text;
    const bool object = value.is(Kind::object);
    const std::string line_end = "\n" + std::string(indent, ' ');
    text = object ? '{' : '[';
    const char* separator = "";
    for (const Member& child : value.children()) {
        const std::string key = object ? json_quoted(child.key) + ": " : "";
        text += separator + line_end + "  " + key +
                pretty(child.value, indent + 2, indent + 2 + key.size(), width);
        separator = ",";
    }
    return text + line_end + (object ? '}' : ']');
}

}  // namespace wrinkle::json
