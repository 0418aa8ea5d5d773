#include "lower/literal.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "base/srgb.h"
#include "base/text.h"

namespace wrinkle {
namespace {

using json::Kind;
using Problems = std::vector<LiteralProblem>;

constexpr double largest = std::numeric_limits<float>::max();

bool is_integer(const json::Value& value) {
    if (!value.is(Kind::number)) return false;
    const double number = value.as_number();
    return std::abs(number) <= 1e9 && number == std::floor(number);
}

std::string found(const json::Value& value) {
    if (value.is(Kind::array)) return "holds an array of " + std::to_string(value.size());
    return std::string("holds ") + json::kind_name(value.kind());
}

std::string remedy(std::string_view word, std::span<const std::string> names) {
    return did_you_mean(word, names, "expected " + one_of(names));
}

// Decodes "#rrggbb", which is display-encoded (sRGB).
bool color_from_hex(std::string_view text, std::array<double, 4>& numbers) {
    if (text.size() != 7 || text[0] != '#') return false;
    for (size_t lane = 0; lane < 3; ++lane) {
        unsigned byte = 0;
        const char* begin = text.data() + 1 + 2 * lane;
        const auto [end, error] = std::from_chars(begin, begin + 2, byte, 16);
        if (error != std::errc() || end != begin + 2) return false;
        numbers[lane] = linear_from_srgb(byte / 255.0);
    }
    return true;
}

void number_problems(const json::Value& value, double number, const Port& port,
                     Problems& problems) {
    if (std::abs(number) > largest)
        return problems.push_back(
            {RuleId::value_range, value,
             "holds " + std::string(value.spelling()) + ", too large for single precision",
             "at most 3.4e38"});
    if (!port.has_hard_range() || (number >= port.hard_min && number <= port.hard_max)) return;
    const double clamped = number < port.hard_min ? port.hard_min : port.hard_max;
    problems.push_back({RuleId::value_range, value,
                        "holds " + std::string(value.spelling()) + ", outside " +
                            shortest(port.hard_min) + " to " + shortest(port.hard_max),
                        shortest(clamped) + " is used", Severity::warning});
}

void numbers_problems(const json::Value& value, const Port& port, Problems& problems) {
    std::array<double, 4> numbers{};
    const int lanes = lanes_of(port.type);
    if (!literal_numbers(value, port.type, numbers)) {
        std::string wanted =
            lanes == 1 ? "a number" : "an array of " + std::to_string(lanes) + " numbers";
        if (port.type == PortType::color_) wanted += " or \"#rrggbb\"";
        problems.push_back({RuleId::wrong_kind, value, found(value), "expected " + wanted});
    } else if (lanes == 1) {
        number_problems(value, numbers[0], port, problems);
    } else {
        size_t lane = 0;
        for (const json::Member& item : value.children())
            number_problems(item.value, numbers[lane++], port, problems);
    }
}

void option_problems(const json::Value& value, const Port& port, Problems& problems) {
    const bool unread = port.kind == Port::Kind::choice && port.choices.empty();
    if (literal_option(value, port) || unread) return;
    if (port.kind == Port::Kind::flag)
        return problems.push_back(
            {RuleId::wrong_kind, value, found(value), "expected true or false"});
    if (port.kind == Port::Kind::choice) {
        if (!value.is(Kind::string))
            return problems.push_back(
                {RuleId::wrong_kind, value, found(value), "expected " + one_of(port.choices)});
        return problems.push_back({RuleId::invalid_value, value,
                                   "has no choice " + json_quoted(value.as_string()),
                                   remedy(value.as_string(), port.choices)});
    }
    std::string wanted = "expected an integer";
    if (port.has_hard_range())
        wanted += " from " + shortest(port.hard_min) + " to " + shortest(port.hard_max);
    const std::string what =
        value.is(Kind::number) ? "holds " + std::string(value.spelling()) : found(value);
    problems.push_back({RuleId::invalid_value, value, what, wanted});
}

// Checks a member of an image object that is one of some words.
template <class Enum>
void word_problems(const json::Member& member, std::span<const std::string_view> words,
                   std::optional<Enum> (*named)(std::string_view), Problems& problems) {
    const std::string key(member.key);
    const std::vector<std::string> names(words.begin(), words.end());
    if (!member.value.is(Kind::string))
        problems.push_back(
            {RuleId::wrong_kind, member.value,
             "has " + std::string(json::kind_name(member.value.kind())) + " as its " + key,
             "expected " + one_of(names)});
    else if (!named(member.value.as_string()))
        problems.push_back({RuleId::invalid_value, member.value,
                            "has the unknown " + key + " " + json_quoted(member.value.as_string()),
                            remedy(member.value.as_string(), names)});
}

void image_problems(const json::Value& value, Problems& problems) {
    static const std::array<std::string, 4> keys = {"file", "encoding", "wrap", "filter"};
    if (value.is(Kind::string)) {
        if (value.as_string().empty())
            problems.push_back({RuleId::image_missing, value, "names no file", "expected a path"});
        return;
    }
    if (!value.is(Kind::object))
        return problems.push_back({RuleId::wrong_kind, value, found(value),
                                   "expected a path or {\"file\": ..., \"encoding\": ...}"});
    const json::Value file = value.find("file");
    if (!file.is(Kind::string) || file.as_string().empty())
        problems.push_back({RuleId::image_missing, value.has("file") ? file : value,
                            "names no file", "expected \"file\": a path"});
    for (const json::Member& member : value.children()) {
        if (member.key == "encoding")
            word_problems<Encoding>(member, encoding_names, encoding_named, problems);
        else if (member.key == "wrap")
            word_problems<Wrap>(member, wrap_names, wrap_named, problems);
        else if (member.key == "filter")
            word_problems<Filter>(member, filter_names, filter_named, problems);
        else if (member.key != "file")
            problems.push_back({RuleId::unknown_key, member.value,
                                "has the unknown key " + json_quoted(member.key),
                                remedy(member.key, keys)});
    }
}

}  // namespace

std::string one_of(std::span<const std::string> names) {
    std::string text;
    for (size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
        text += names[i];
    }
    return text;
}

bool literal_numbers(const json::Value& value, PortType type, std::array<double, 4>& numbers) {
    if (type == PortType::color_ && value.is(Kind::string))
        return color_from_hex(value.as_string(), numbers);
    const auto lanes = static_cast<size_t>(lanes_of(type));
    if (lanes == 1 && value.is(Kind::number)) {
        numbers[0] = value.as_number();
        return true;
    }
    if (lanes < 2 || !value.is(Kind::array) || value.size() != lanes) return false;
    size_t lane = 0;
    for (const json::Member& item : value.children()) {
        if (!item.value.is(Kind::number)) return false;
        numbers[lane++] = item.value.as_number();
    }
    return true;
}

std::optional<int32_t> literal_option(const json::Value& value, const Port& port) {
    if (port.kind == Port::Kind::flag) {
        if (!value.is(Kind::boolean)) return {};
        return value.as_boolean() ? 1 : 0;
    }
    if (port.kind == Port::Kind::choice) {
        if (!value.is(Kind::string)) return {};
        for (size_t i = 0; i < port.choices.size(); ++i)
            if (port.choices[i] == value.as_string()) return static_cast<int32_t>(i);
        return {};
    }
    if (!is_integer(value)) return {};
    const double number = value.as_number();
    if (port.has_hard_range() && (number < port.hard_min || number > port.hard_max)) return {};
    return static_cast<int32_t>(number);
}

ImageLiteral literal_image(const json::Value& value) {
    ImageLiteral image;
    if (value.is(Kind::string)) {
        image.file = value.as_string();
        return image;
    }
    const auto word = [&](std::string_view key) {
        const json::Value found = value.is(Kind::object) ? value.find(key) : json::Value{};
        return found.is(Kind::string) ? found.as_string() : std::string_view{};
    };
    image.file = word("file");
    image.encoding = encoding_named(word("encoding"));
    image.wrap = wrap_named(word("wrap")).value_or(Wrap::repeat);
    image.filter = filter_named(word("filter")).value_or(Filter::linear);
    return image;
}

std::vector<LiteralProblem> literal_problems(const json::Value& value, const Port& port) {
    Problems problems;
    if (port.is_option()) {
        option_problems(value, port, problems);
    } else if (port.type == PortType::image_) {
        image_problems(value, problems);
    } else if (lanes_of(port.type) > 0) {
        numbers_problems(value, port, problems);
    } else {
        problems.push_back({RuleId::wrong_kind, value, found(value),
                            "a " + std::string(name_of(port.type)) + " comes from a wire"});
    }
    return problems;
}

}  // namespace wrinkle
