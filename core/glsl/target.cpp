#include "glsl/target.h"

#include <array>

namespace wrinkle {
namespace {

constexpr std::array<Target, 1> table{{
    {"glsl330", "#version 330 core", "dFdx", "dFdy", "OpenGL 3.3 and later"},
}};

}  // namespace

std::span<const Target> targets() {
    return table;
}

const Target* find_target(std::string_view name) {
    for (const Target& target : table)
        if (target.name == name) return &target;
    return nullptr;
}

}  // namespace wrinkle
