#include <algorithm>
#include <array>

#include "gpu/renderer.h"

namespace wrinkle::gpu {
namespace {

constexpr std::array<std::string_view, 2> lightings{"ggx", "phong"};
constexpr std::array<std::string_view, 7> views{"shaded", "normal",     "gradient", "height",
                                                "uv",     "difference", "wireframe"};

}  // namespace

std::span<const std::string_view> lighting_names() {
    return lightings;
}

std::span<const std::string_view> view_names() {
    return views;
}

std::optional<View> view_named(std::string_view name) {
    const auto* found = std::ranges::find(views, name);
    if (found == views.end()) return std::nullopt;
    return static_cast<View>(found - views.begin());
}

}  // namespace wrinkle::gpu
