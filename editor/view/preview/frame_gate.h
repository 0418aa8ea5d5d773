// Lets the window's frames interrupt slow renderings. Some drivers draw for all contexts
// sequentially on the same cores, so that a frame submitted after a rendering of the material waits
// for it. A slow rendering is therefore drawn in strips; it calls wait_for_frame() between them.
//
// The window's thread makes Frames; the render thread waits. Thread-safe for these two.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace wrinkle::editor {

class FrameGate {
public:
    using Frame = std::lock_guard<FrameGate>;  // a frame is drawn while this object exists
    void lock() { set(true); }
    void unlock() { set(false); }

    // Waits until the frame in progress is finished, if any; at most 25 ms, so that renderings make
    // progress while a frame waits for the display.
    void wait_for_frame() {
        std::unique_lock lock(mutex_);
        changed_.wait_for(lock, longest, [this] { return !frame_; });
    }

private:
    static constexpr std::chrono::milliseconds longest{25};
    void set(bool frame) {
        {
            const std::lock_guard lock(mutex_);
            frame_ = frame;
        }
        changed_.notify_all();
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    bool frame_ = false;
};

}  // namespace wrinkle::editor
