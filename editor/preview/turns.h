// Whose turn it is to draw. Some drivers draw for all contexts one after another, on the same
// cores: a window's frame that comes behind a picture of the material waits for it. So a picture
// that takes long is drawn in strips, and between two of them gives way to a frame.
//
// Each side has a thread of its own.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace wrinkle::editor {

class Turns {
public:
    // A frame is being drawn while it lives.
    class Frame {
    public:
        explicit Frame(Turns& turns) : turns_(turns) { turns_.set(true); }
        ~Frame() { turns_.set(false); }
        Frame(const Frame&) = delete;
        Frame& operator=(const Frame&) = delete;

    private:
        Turns& turns_;
    };

    // Until no frame is being drawn, though not for ever: one that waits for the screen leaves the
    // driver free, and pictures have to get on.
    void give_way() {
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
