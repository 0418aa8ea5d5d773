// Color scale from low to high: cividis, uniform and monotone also with color vision deficiencies.
#pragma once

#include <imgui.h>

#include <array>

namespace wrinkle::editor {

inline constexpr std::array<unsigned, 10> heat_stops = {0x00224E, 0x123570, 0x3B496C, 0x575D6D,
                                                        0x707173, 0x8A8678, 0xA59C74, 0xC3B369,
                                                        0xE1CC55, 0xFEE838};

struct HeatColor {
    ImU32 ground;
    ImU32 text;  // black or white, whichever has more contrast on it
};
HeatColor heat_color(float part);  // 0 to 1

}  // namespace wrinkle::editor
