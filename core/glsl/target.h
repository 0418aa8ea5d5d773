// The shading languages that a module can be written in, one table row each.
#pragma once

#include <span>
#include <string_view>

namespace wrinkle {

struct Target {
    std::string_view name;      // "glsl330", as --target takes it
    std::string_view version;   // first line of a complete shader
    std::string_view change_x;  // the functions that give the change to the next pixel
    std::string_view change_y;
    std::string_view doc;
};

std::span<const Target> targets();  // the first is the default
const Target* find_target(std::string_view name);

}  // namespace wrinkle
