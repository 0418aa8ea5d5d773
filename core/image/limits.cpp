#include <charconv>
#include <cstdlib>
#include <limits>
#include <string_view>

#include "image/load.h"

namespace wrinkle {

namespace {

template <typename Number>
void read_limit(const char* variable, Number& limit, Diagnostics& diagnostics) {
    const char* text = std::getenv(variable);
    if (!text) return;
    const std::string_view digits = text;
    Number value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc() && end == digits.data() + digits.size() && value > 0)
        limit = value;
    else
        diagnostics.error(
            "environment variable " + std::string(variable) + " is '" + text + "'",
            "a whole number from 1 to " + std::to_string(std::numeric_limits<Number>::max()));
}

}  // namespace

ImageLimits image_limits_from_environment(Diagnostics& diagnostics) {
    ImageLimits limits;
    read_limit("WRINKLE_IMAGE_MAX_SIDE", limits.max_side, diagnostics);
    read_limit("WRINKLE_IMAGE_MAX_PIXELS", limits.max_pixels, diagnostics);
    read_limit("WRINKLE_IMAGE_MAX_BYTES", limits.max_bytes, diagnostics);
    return limits;
}

}  // namespace wrinkle
