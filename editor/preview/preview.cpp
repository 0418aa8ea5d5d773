#include "editor/preview/preview.h"

#include <epoxy/gl.h>

#include "mesh/shapes.h"

namespace wrinkle::editor {

bool Preview::set_material(const gpu::Material& material, Diagnostics& problems) {
    if (!renderer_.set_material(material, problems)) return false;
    has_material_ = changed_ = true;
    return true;
}

void Preview::set_uniform(const std::string& name, std::span<const float> value) {
    if (has_material_ && renderer_.set_uniform(name, value)) changed_ = true;
}

void Preview::use_mesh(const std::string& name) {
    if (name == mesh_) return;
    const auto mesh = make_shape(name);
    if (!mesh) return;
    renderer_.set_mesh(*mesh);
    framing_ = gpu::default_camera(*mesh, name);
    mesh_ = name;
    changed_ = true;
}

uint32_t Preview::picture(const PreviewView& view, int width, int height, Diagnostics& problems) {
    if (!has_material_ || width < 1 || height < 1) return 0;
    use_mesh(view.mesh);
    if (!target_ || target_->width() != width || target_->height() != height) {
        gpu::TargetOptions options;
        options.width = width;
        options.height = height;
        options.samples = 4;
        auto target = gpu::Target::make(options, problems);
        if (!target) return has_picture_ ? target_->texture() : 0;
        target_ = std::move(target);
        changed_ = true;
    }
    if (changed_ || view != drawn_) {
        gpu::Scene scene;
        scene.camera = framing_;
        scene.camera.yaw = view.yaw;
        scene.camera.pitch = view.pitch;
        scene.camera.distance = framing_.distance * view.distance;
        gpu::ViewOptions options;
        options.view = view.view;
        if (renderer_.draw(scene, options, *target_, problems)) has_picture_ = true;
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        drawn_ = view;
        changed_ = false;
    }
    return has_picture_ ? target_->texture() : 0;
}

}  // namespace wrinkle::editor
