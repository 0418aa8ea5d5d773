// The picture of the material: an object drawn into a texture that the window shows.
//
// Everything that the panels need stands in this small face, so that the drawing may move to a
// thread of its own. Wants a GL context current on the calling thread. The last good picture stays
// when a material cannot be used.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gpu/renderer.h"

namespace wrinkle::editor {

struct PreviewView {
    std::string mesh = "sphere";
    gpu::View view = gpu::View::shaded;
    float yaw = 0.5F, pitch = 0.25F;  // radians
    float distance = 1;               // times that at which all of the mesh is seen
    bool operator==(const PreviewView&) const = default;
};

class Preview {
public:
    // False, with the reason, when the former material stays.
    bool set_material(const gpu::Material& material, Diagnostics& problems);
    void set_uniform(const std::string& name, std::span<const float> value);
    void forget_images() { renderer_.forget_images(); }

    // The newest picture as a GL texture, bottom row first; 0 when there has never been one. Draws
    // only when something has changed.
    uint32_t picture(const PreviewView& view, int width, int height, Diagnostics& problems);

private:
    void use_mesh(const std::string& name);

    gpu::Renderer renderer_;
    std::optional<gpu::Target> target_;
    gpu::OrbitCamera framing_;
    PreviewView drawn_;
    std::string mesh_;
    bool has_material_ = false, changed_ = true, has_picture_ = false;
};

}  // namespace wrinkle::editor
