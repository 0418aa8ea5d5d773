#include "import/mtlx_value.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text.h"

namespace wrinkle::materialx {
namespace {

struct TypeRow {
    std::string_view name;
    Type type;
    int size;
};

constexpr std::array types = {
    TypeRow{"float", Type::float_, 1},         TypeRow{"integer", Type::integer, 1},
    TypeRow{"boolean", Type::boolean, 1},      TypeRow{"color3", Type::color3, 3},
    TypeRow{"color4", Type::color4, 4},        TypeRow{"vector2", Type::vector2, 2},
    TypeRow{"vector3", Type::vector3, 3},      TypeRow{"vector4", Type::vector4, 4},
    TypeRow{"string", Type::string, 0},        TypeRow{"filename", Type::filename, 0},
    TypeRow{"surfaceshader", Type::shader, 0}, TypeRow{"displacementshader", Type::shader, 0},
    TypeRow{"material", Type::shader, 0},
};

std::string_view without_spaces(std::string_view text) {
    constexpr std::string_view spaces = " \t\r\n";
    const size_t first = text.find_first_not_of(spaces);
    if (first == text.npos) return {};
    return text.substr(first, text.find_last_not_of(spaces) + 1 - first);
}

std::optional<double> parse_number(std::string_view text) {
    text = without_spaces(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(text.data(), end, number);
    constexpr double largest = std::numeric_limits<float>::max();
    if (problem != std::errc() || stop != end || !(std::abs(number) <= largest)) return {};
    return number;
}

}  // namespace

Type type_named(std::string_view name) {
    const auto found = std::ranges::find(types, name, &TypeRow::name);
    return found == types.end() ? Type::none : found->type;
}

std::string_view name_of(Type type) {
    const auto found = std::ranges::find(types, type, &TypeRow::type);
    return found == types.end() ? "unknown type" : found->name;
}

int size_of(Type type) {
    const auto found = std::ranges::find(types, type, &TypeRow::type);
    return found == types.end() ? 0 : found->size;
}

bool Value::is_literal() const {
    if (is_bad || image || bump || is_surface_normal) return false;
    for (int i = 0; i < size_of(type); ++i) {
        const auto& part = parts[static_cast<size_t>(i)];
        if (!part || !part->is_literal()) return false;
    }
    return true;
}

Value bad_value() {
    Value value;
    value.is_bad = true;
    return value;
}

Value literal_value(Type type, const std::vector<double>& numbers) {
    Value value;
    value.type = type;
    for (size_t i = 0; i < numbers.size(); ++i)
        value.parts[i] = Number{numbers[i]};
    return value;
}

Value wire_value(Type type, Link link) {
    Value value;
    value.type = type;
    if (size_of(type) == 1)
        value.parts[0] = Number{0, std::move(link)};
    else
        value.whole = std::move(link);
    return value;
}

std::optional<Value> parse_value(Type type, std::string_view text) {
    Value value;
    value.type = type;
    if (type == Type::string || type == Type::filename) {
        value.text = std::string(text);
        return value;
    }
    if (type == Type::boolean) {
        text = without_spaces(text);
        if (text != "true" && text != "false") return {};
        return literal_value(type, {text == "true" ? 1.0 : 0.0});
    }
    const auto parts = split(text, ',');
    if (size_of(type) == 0 || parts.size() != static_cast<size_t>(size_of(type))) return {};
    std::vector<double> numbers;
    for (const std::string_view part : parts) {
        const auto number = parse_number(part);
        if (!number || (type == Type::integer && *number != std::floor(*number))) return {};
        numbers.push_back(*number);
    }
    return literal_value(type, numbers);
}

}  // namespace wrinkle::materialx
