#include "editor/model/document/field.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "base/text.h"
#include "graph/edit.h"
#include "lower/literal.h"

namespace wrinkle::editor {
namespace {

const Input* literal_at(const Node& node, const Port& port) {
    const Input* input = node.find(port.name);
    return input && input->kind == Input::Kind::literal ? input : nullptr;
}

Document write_or_reset(const Document& document, std::string_view node, const Port& port,
                        bool is_default, json::Value value) {
    if (is_default) return reset_value(document, node, port.name);
    return set_value(document, node, port.name, std::move(value));
}

double clamped(double value, const Port& port) {
    if (!port.has_hard_range()) return value;
    return std::clamp(value, port.hard_min, port.hard_max);
}

bool is_count(const Port& port) {
    return port.kind == Port::Kind::count;
}

// Rounds to a decimal step of 1/1000 to 1/100 of `range`, with 0 to 9 decimals.
double rounded(double value, double range) {
    const int decimals = std::clamp(3 - static_cast<int>(std::ceil(std::log10(range))), 0, 9);
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return std::strtod(text, nullptr) + 0.0;  // never -0
}

std::string shown_unit(const Port& port) {
    if (lanes_of_field(port) > 1) return "";  // no room for units
    if (port.unit == "x") return " \u00D7";
    if (port.unit == "deg") return "\u00B0";
    return port.unit.empty() ? "" : " " + port.unit;
}

// Uses an exponent only for numbers with many zeros.
std::string spelled(float value) {
    const float size = std::fabs(value);
    if (size != 0 && (size < 1e-4F || size >= 1e7F)) return shortest(value);
    char text[48];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed);
    return {text, end.ptr};
}

std::string rounded_to(float value, int decimals, bool exponent) {
    char text[64];
    std::snprintf(text, sizeof text, exponent ? "%.*e" : "%.*f", decimals,
                  static_cast<double>(value));
    std::string shown = text;
    if (exponent || decimals == 0) return shown;
    shown.erase(shown.find_last_not_of('0') + 1);
    if (shown.ends_with('.')) shown.pop_back();
    return shown == "-0" ? "0" : shown;
}

}  // namespace

int lanes_of_field(const Port& port) {
    if (is_count(port)) return 1;
    if (!port.is_value() || port.default_kind == Port::Default::surface) return 0;
    return lanes_of(port.type);
}

std::array<double, 4> numbers_at(const Node& node, const Port& port) {
    std::array<double, 4> numbers = port.default_value;
    const Input* input = literal_at(node, port);
    if (!input) return numbers;
    if (port.is_option()) {
        if (const auto option = literal_option(input->value, port)) numbers[0] = *option;
    } else {
        literal_numbers(input->value, port.type, numbers);
    }
    return numbers;
}

json::Value literal_of(const std::array<double, 4>& numbers, int lanes) {
    if (lanes == 1) return json::Value::number(numbers[0]);
    std::vector<json::Value> items;
    for (size_t i = 0; i < static_cast<size_t>(lanes); ++i)
        items.push_back(json::Value::number(numbers[i]));
    return json::Value::array(items);
}

std::string shown_number(double value, const Port& port, const Fits& fits) {
    const std::string unit = shown_unit(port);
    const auto value_as_float = static_cast<float>(value + 0.0);  // never -0
    std::string text = spelled(value_as_float);
    if (fits(text + unit)) return text + unit;
    const bool less_than_one = text.starts_with("0.") || text.starts_with("-0.");
    if (less_than_one) text.erase(text.find('0'), 1);
    const bool exponent = text.find('e') != text.npos;
    for (int decimals = 8; !fits(text + unit) && decimals-- > 0;)
        text = rounded_to(value_as_float, decimals, exponent);
    return text + unit;
}

std::string shown_value(const Node& node, const Port& port, const Fits& fits) {
    const double first = numbers_at(node, port)[0];
    if (port.kind == Port::Kind::choice) {
        const auto index = static_cast<size_t>(first);
        return index < port.choices.size() ? port.choices[index] : "?";
    }
    if (port.kind == Port::Kind::flag) return first != 0 ? "yes" : "no";
    if (port.is_value() && port.type == PortType::image_) {
        const Input* input = literal_at(node, port);
        const std::string_view file = input ? literal_image(input->value).file : "";
        return file.empty() ? "choose..." : std::filesystem::path(file).filename().string();
    }
    if (lanes_of_field(port) > 0) return shown_number(first, port, fits);
    if (port.default_kind == Port::Default::surface)
        return std::string(surface_properties()[port.default_surface].name);
    return {};
}

Document with_number(const Document& document, std::string_view node, const Port& port, int lane,
                     double value) {
    const Node* target = document.find(node);
    if (!target || !std::isfinite(value)) return document;
    std::array<double, 4> numbers = numbers_at(*target, port);
    numbers[static_cast<size_t>(lane)] = clamped(is_count(port) ? std::round(value) : value, port);
    const int lanes = lanes_of_field(port);
    const bool is_default =
        port.default_kind == Port::Default::constant &&
        std::equal(numbers.begin(), numbers.begin() + lanes, port.default_value.begin());
    return write_or_reset(document, node, port, is_default, literal_of(numbers, lanes));
}

Document with_choice(const Document& document, std::string_view node, const Port& port,
                     uint32_t choice) {
    if (choice >= port.choices.size()) return document;
    return write_or_reset(document, node, port, choice == port.default_value[0],
                          json::Value::string(port.choices[choice]));
}

Document with_flag(const Document& document, std::string_view node, const Port& port, bool value) {
    return write_or_reset(document, node, port, value == (port.default_value[0] != 0),
                          json::Value::boolean(value));
}

json::Value with_file(const json::Value& image, std::string_view file) {
    const json::Value name = json::Value::string(file);
    if (!image.is(json::Kind::object)) return name;
    std::vector<std::pair<std::string, json::Value>> members;
    for (const json::Member& member : image.children())
        members.emplace_back(member.key, member.key == "file" ? name : member.value);
    return json::Value::object(members);
}

Document with_file(const Document& document, std::string_view node, const Port& port,
                   std::string_view file) {
    const Node* target = document.find(node);
    if (!target) return document;
    const Input* old = literal_at(*target, port);
    return set_value(document, node, port.name, with_file(old ? old->value : json::Value(), file));
}

Document with_image_word(const Document& document, std::string_view node, const Port& port,
                         std::string_view key, std::string_view word) {
    const Node* target = document.find(node);
    const Input* old = target ? literal_at(*target, port) : nullptr;
    if (!old) return document;
    const bool usual = word == (key == "encoding" ? name_of(port.encoding) : name_of(Wrap{}));
    std::vector<std::pair<std::string, json::Value>> members;
    if (!old->value.is(json::Kind::object)) members.emplace_back("file", old->value);
    for (const json::Member& member : old->value.children())
        if (member.key != key) members.emplace_back(member.key, member.value);
    if (!usual) members.emplace_back(key, json::Value::string(std::string(word)));
    const bool bare = members.size() == 1 && members[0].first == "file";
    return set_value(document, node, port.name,
                     bare ? members[0].second : json::Value::object(members));
}

double dragged(double start, double pixels, double width, const Port& port, bool fine,
               bool coarse) {
    if (is_count(port)) return start + std::trunc(pixels / 12);
    double range =
        port.has_soft_range() ? port.soft_max - port.soft_min : std::max(std::fabs(start), 0.1) * 4;
    if (fine) range /= 20;
    if (coarse) range *= 10;
    return rounded(start + pixels / std::max(width, 1.0) * range, range);
}

}  // namespace wrinkle::editor
