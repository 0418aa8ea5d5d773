// Preview of the material, drawn on a thread with a GL context that shares textures with the
// window's. The newest job wins; the interface shows the newest rendering.
//
// If no such context can be made, it is drawn synchronously on the calling thread.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "editor/model/document/used_files.h"
#include "editor/model/worker.h"
#include "editor/view/preview/frame_gate.h"
#include "editor/view/preview/painter.h"
#include "gpu/context.h"

namespace wrinkle::editor {

class Preview {
public:
    // Precondition: a GL context is current; later calls come from the same thread. `wake` is
    // called on the preview's thread when there is a new rendering.
    explicit Preview(std::function<void()> wake = {});

    void set_material(std::shared_ptr<const Shader> material,
                      std::shared_ptr<const Displacement> displacement);
    // Called when another graph is opened: nothing is shown until there is a material.
    void forget_material();
    void set_uniform(const std::string& name, std::span<const float> value);
    // Images, the mesh or the light are read again for the next rendering.
    void forget(Use use);
    // Drawn once, as requested by the last show().
    void draw_image_request(std::shared_ptr<ImageRequest> request);
    // Sets view and comparison for the same material; width and height in pixels.
    void show(const PreviewView& view, const std::string& against, const CompareView& compare,
              int width, int height);

    // While the returned object exists, the window draws a frame and a slow rendering pauses.
    FrameGate::Frame frame() { return FrameGate::Frame(gate_); }

    // leave_context() releases everything made in the window's context, which is destroyed next;
    // recreate_context() makes it again in the current one and draws again.
    void leave_context();
    void recreate_context();

    // Returns the newest rendering. Its textures are valid until the next call.
    const PreviewImage& newest();
    const PreviewImage& shown() const { return image_; }  // the last result, without polling
    uint64_t asked() const { return job_.version; }
    // Returns true if no job is pending, including the smooth drawing of the last one.
    bool idle() const;
    void wait_idle();
    bool has_thread() const { return worker_ != nullptr; }
    ~Preview();

private:
    void begin();
    void submit();
    bool can_smooth() const;

    PreviewJob job_;
    std::function<void()> wake_;
    bool changed_ = false;
    PreviewImage image_;
    std::atomic<int> held_ = -1;
    FrameGate gate_;
    std::unique_ptr<PreviewPainter> painter_;                   // used by one thread only
    std::optional<gpu::Context> context_;                       // owned by the worker
    std::unique_ptr<Worker<PreviewJob, PreviewImage>> worker_;  // destroyed first
};

}  // namespace wrinkle::editor
