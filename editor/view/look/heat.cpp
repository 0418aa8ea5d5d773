#include "editor/view/look/heat.h"

#include <algorithm>
#include <cmath>

namespace wrinkle::editor {

HeatColor heat_color(float part) {
    const float at = std::clamp(part, 0.0F, 1.0F) * (heat_stops.size() - 1);
    const size_t low = std::min(static_cast<size_t>(at), heat_stops.size() - 2);
    const float t = at - static_cast<float>(low);
    const auto channel = [&](unsigned shift) {
        const auto a = static_cast<float>(heat_stops[low] >> shift & 255);
        const auto b = static_cast<float>(heat_stops[low + 1] >> shift & 255);
        return static_cast<int>(std::lround(a + (b - a) * t));
    };
    // Black and white have equal contrast at luminance 0.18, a quarter step after the fifth stop.
    const ImU32 text = at <= 4.25F ? IM_COL32(255, 255, 255, 255) : IM_COL32(0, 0, 0, 255);
    return {IM_COL32(channel(16), channel(8), channel(0), 255), text};
}

}  // namespace wrinkle::editor
