// View settings of the preview: plain values, never saved in the graph.
#pragma once

#include <string>

#include "gpu/renderer.h"

namespace wrinkle::editor {

struct PreviewView {
    std::string mesh = "sphere";  // a shape's name, or the path of an OBJ or glTF file
    std::string environment;      // path of an .hdr or .exr; "" is a sky over a ground
    gpu::View view = gpu::View::shaded;
    gpu::Lighting lighting = gpu::Lighting::ggx;
    float yaw = 0.5F, pitch = 0.25F;  // eye direction, radians
    float distance = 1;               // as multiple of the distance that shows the entire mesh
    float pan_x = 0, pan_y = 0;       // shift of the target, in units of that distance
    float light_yaw = -0.695F, light_pitch = 0.731F;  // towards the light, radians
    float turn = 0;                                   // rotation of the environment, radians
    float scale = 1;         // scale of the mesh's coordinates: heights keep their length
    bool displaced = false;  // by the output `displacement`
    bool operator==(const PreviewView&) const = default;
};

// Comparison of the material with another normal, side by side, or the angle between the two.
struct CompareView {
    enum class Mode : uint8_t { off, split, flip };
    Mode mode = Mode::off;
    bool difference = false;  // side B shows degrees, else the other normal
    float degrees = 0;        // end of the heat map's scale; 0: automatic
    float split = 0.5F;       // fraction of the width
    bool flipped = false;     // side B is shown
    bool operator==(const CompareView&) const = default;
};

}  // namespace wrinkle::editor
