#include "registry/standard.h"

#include <algorithm>
#include <array>

namespace wrinkle {
namespace {

constexpr std::array<std::string_view, 7> output_names = {
    "normal", "height", "displacement", "color", "roughness", "metalness", "occlusion"};
constexpr std::array<PortType, 7> output_types = {
    PortType::normal_, PortType::height_, PortType::height_, PortType::color_,
    PortType::float_,  PortType::float_,  PortType::float_};

}  // namespace

std::optional<PortType> standard_output(std::string_view name) {
    const auto* const found = std::find(output_names.begin(), output_names.end(), name);
    if (found == output_names.end()) return {};
    return output_types[static_cast<size_t>(found - output_names.begin())];
}

std::span<const std::string_view> standard_outputs() {
    return output_names;
}

bool is_name(std::string_view text) {
    const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto inside = [&](char c) { return lower(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !text.empty() && text.size() <= max_name && lower(text[0]) &&
           std::all_of(text.begin(), text.end(), inside);
}

}  // namespace wrinkle
