#include "base/texture_options.h"

#include <algorithm>
#include <array>

namespace wrinkle {

namespace {

constexpr std::array<std::string_view, 7> encodings = {
    "linear", "srgb", "normal_gl", "normal_dx", "normal_rg", "normal_ag", "derivative"};
constexpr std::array<std::string_view, 3> wraps = {"repeat", "clamp", "mirror"};
constexpr std::array<std::string_view, 2> filters = {"linear", "nearest"};

template <typename Enum>
std::optional<Enum> named(std::span<const std::string_view> names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    return static_cast<Enum>(found - names.begin());
}

}  // namespace

std::span<const std::string_view> encoding_names() {
    return encodings;
}

std::span<const std::string_view> wrap_names() {
    return wraps;
}

std::span<const std::string_view> filter_names() {
    return filters;
}

std::string_view name_of(Encoding encoding) {
    return encodings[static_cast<size_t>(encoding)];
}

std::string_view name_of(Wrap wrap) {
    return wraps[static_cast<size_t>(wrap)];
}

std::string_view name_of(Filter filter) {
    return filters[static_cast<size_t>(filter)];
}

std::optional<Encoding> encoding_named(std::string_view name) {
    return named<Encoding>(encodings, name);
}

std::optional<Wrap> wrap_named(std::string_view name) {
    return named<Wrap>(wraps, name);
}

std::optional<Filter> filter_named(std::string_view name) {
    return named<Filter>(filters, name);
}

}  // namespace wrinkle
