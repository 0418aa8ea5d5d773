// Outputs of a graph that have a meaning in every host. A further one is a row here, its line in
// docs/graph-format.md and its test.
#pragma once

#include <string_view>

namespace wrinkle {

struct StandardOutput {
    std::string_view name;
    std::string_view type;  // its port type; "": a color, vec3 or float
    int rank;               // order of the fragment outputs of a shader
    std::string_view doc;   // comment in generated source: unit, space, range
};

// In the order of documents and cards.
inline constexpr StandardOutput standard_output_table[] = {
    {"normal", "normal", 0, "unit normal, object space"},
    {"height", "height", 5, "outwards, in length units"},
    {"displacement", "height", 6, "along the normal, in length units"},
    {"color", "color", 1, "base color, linear"},
    {"roughness", "float", 2, "perceptual, 0 to 1"},
    {"metalness", "float", 3, "0 dielectric, 1 metal"},
    {"occlusion", "float", 4, "1: no occlusion"},
    {"emission", "", 7, "emitted radiance, linear"},
};

// Returns nullptr for other names.
constexpr const StandardOutput* find_standard_output(std::string_view name) {
    for (const StandardOutput& output : standard_output_table)
        if (output.name == name) return &output;
    return nullptr;
}

}  // namespace wrinkle
