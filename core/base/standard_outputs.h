// Outputs of a graph that have a meaning in every host. A further one is a row here, its line in
// docs/graph-format.md and its test.
#pragma once

#include <string_view>

namespace wrinkle {

struct StandardOutput {
    std::string_view name;
    std::string_view type;  // its port type; "": a color, vec3 or float
    int rank;               // order of the fragment outputs of a shader
};

// In the order of documents and cards.
inline constexpr StandardOutput standard_output_table[] = {
    {"normal", "normal", 0},   {"height", "height", 5},   {"displacement", "height", 6},
    {"color", "color", 1},     {"roughness", "float", 2}, {"metalness", "float", 3},
    {"occlusion", "float", 4}, {"emission", "", 7},
};

// Returns nullptr for other names.
constexpr const StandardOutput* find_standard_output(std::string_view name) {
    for (const StandardOutput& output : standard_output_table)
        if (output.name == name) return &output;
    return nullptr;
}

}  // namespace wrinkle
