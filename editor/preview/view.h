// How the material is looked at in the preview: plain values, never saved in the graph.
#pragma once

#include <string>

#include "gpu/renderer.h"

namespace wrinkle::editor {

struct PreviewView {
    std::string mesh = "sphere";  // a shape's name, or the path of an OBJ or glTF file
    std::string environment;      // the path of an .hdr or .exr; "" is a sky over a ground
    gpu::View view = gpu::View::shaded;
    gpu::Lighting lighting = gpu::Lighting::ggx;
    float yaw = 0.5F, pitch = 0.25F;  // of the eye, radians
    float distance = 1;               // times that at which all of the mesh is seen
    float pan_x = 0, pan_y = 0;       // of what is looked at, in times of that distance
    float light_yaw = -0.695F, light_pitch = 0.731F;  // towards the light, radians
    float turn = 0;                                   // of the surroundings, radians
    float scale = 1;         // of the mesh's coordinates: heights keep their length
    bool displaced = false;  // by the output `displacement`
    bool operator==(const PreviewView&) const = default;
};

// The same material with another normal beside it, or the angle between the two.
struct CompareView {
    enum class Mode : uint8_t { off, split, flip };
    Mode mode = Mode::off;
    bool difference = false;  // side B shows degrees, else the other picture
    float degrees = 0;        // at the end of the scale; 0 finds it
    float split = 0.5F;       // of the picture's width
    bool flipped = false;     // side B is shown
    bool operator==(const CompareView&) const = default;
};

}  // namespace wrinkle::editor
