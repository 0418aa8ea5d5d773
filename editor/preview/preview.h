// The picture of the material, drawn on a thread of its own with a GL context that shares textures
// with the window's. The newest job wins; the interface shows the newest picture there is.
//
// Where no such context can be made the same is drawn at once, on the thread that asks.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "editor/preview/painter.h"
#include "editor/preview/turns.h"
#include "editor/worker.h"
#include "gpu/context.h"

namespace wrinkle::editor {

class Preview {
public:
    // Wants a GL context current; later calls come from the same thread. wake is called on the
    // other one whenever there is a new picture.
    explicit Preview(std::function<void()> wake = {});

    void set_material(std::shared_ptr<const gpu::Material> material,
                      std::shared_ptr<const Displacement> displacement);
    // Another graph is open: nothing is shown until it has a material.
    void forget_material();
    void set_uniform(const std::string& name, std::span<const float> value);
    // Their files are read again, by the next picture.
    void forget_images();
    void forget_mesh();
    void forget_light();
    // Drawn once, of what show() has asked for last.
    void draw_still(std::shared_ptr<Still> still);
    // Of the same material; width and height in pixels.
    void show(const PreviewView& view, const std::string& against, const CompareView& compare,
              int width, int height);

    // While it lives the window draws a frame, and a picture that takes long pauses.
    Turns::Frame frame() { return Turns::Frame(turns_); }

    // Gives up all that was made in the window's context, which goes next; then makes it anew in
    // the one that is current, and draws the same again.
    void leave_context();
    void renew();

    // The newest there is. Its textures hold until the next call.
    const PreviewPicture& picture();
    const PreviewPicture& shown() const { return picture_; }  // what picture() gave last
    uint64_t asked() const { return job_.version; }
    bool idle() const;  // no picture is on its way; none is while nobody shows one
    void settle();
    bool has_thread() const { return worker_ != nullptr; }
    ~Preview();

private:
    void begin();
    void ask();

    PreviewJob job_;
    std::function<void()> wake_;
    bool changed_ = false;
    PreviewPicture picture_;
    std::atomic<int> held_ = -1;
    Turns turns_;
    std::unique_ptr<PreviewPainter> painter_;                     // used by one thread alone
    std::optional<gpu::Context> context_;                         // of the worker
    std::unique_ptr<Worker<PreviewJob, PreviewPicture>> worker_;  // goes first
};

}  // namespace wrinkle::editor
