#include "base/texture_options.h"

#include <algorithm>
#include <span>

namespace wrinkle {
namespace {

template <typename Enum>
std::optional<Enum> named(std::span<const std::string_view> names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return {};
    return static_cast<Enum>(found - names.begin());
}

}  // namespace

std::optional<Encoding> encoding_named(std::string_view name) {
    return named<Encoding>(encoding_names, name);
}

std::optional<Wrap> wrap_named(std::string_view name) {
    return named<Wrap>(wrap_names, name);
}

std::optional<Filter> filter_named(std::string_view name) {
    return named<Filter>(filter_names, name);
}

}  // namespace wrinkle
