#include "emit/literal.h"

#include <cmath>

#include "base/text.h"

namespace wrinkle {
namespace {

constexpr double min_int = -2147483648.0;

void append_float(const Language& language, std::string& text, double value) {
    const auto narrow = static_cast<float>(value);
    if (std::isnan(narrow)) {
        text += language.not_a_number;
    } else if (std::isinf(narrow)) {
        text += narrow > 0 ? language.infinity : language.minus_infinity;
    } else {
        const size_t begin = text.size();
        text += shortest(narrow);
        if (text.find('.', begin) == text.npos && text.find('e', begin) == text.npos) text += ".0";
    }
}

}  // namespace

void append_literal(const Language& language, std::string& text, Type type, double value) {
    switch (type) {
        case Type::int_:
            text += value <= min_int ? "(-2147483647 - 1)"
                                     : std::to_string(static_cast<int64_t>(value));
            break;
        case Type::uint_:
            append_filled(text, language.uint_literal,
                          {{'v', language.uint_literal_is_int
                                     ? std::to_string(static_cast<int32_t>(
                                           static_cast<uint32_t>(static_cast<int64_t>(value))))
                                     : std::to_string(static_cast<int64_t>(value))}});
            break;
        case Type::bool_:
            text += value != 0 ? "true" : "false";
            break;
        default:
            append_float(language, text, value);
    }
}

bool is_negative_literal(Type type, double value) {
    if (type == Type::int_) return value < 0 && value > min_int;
    return type == Type::float_ && std::signbit(value) && std::isfinite(static_cast<float>(value));
}

}  // namespace wrinkle
