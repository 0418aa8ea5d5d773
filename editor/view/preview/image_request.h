// An image of the preview in a given size: one thread requests it, the preview's thread draws it.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

#include "base/diagnostics.h"
#include "image/image.h"

namespace wrinkle::editor {

class ImageRequest {
public:
    // In a comparison, the left part up to `split` of the width is from side A, the rest from side
    // B.
    ImageRequest(int wide, int tall, float split) : width(wide), height(tall), split(split) {}
    const int width, height;
    const float split;
    std::atomic<bool> cancelled = false;

    bool answered() const {
        const std::lock_guard lock(mutex_);
        return answered_;
    }
    // Called by the preview: sets the image, or std::nullopt with the reasons.
    void answer(std::optional<Image> image, Diagnostics problems) {
        {
            const std::lock_guard lock(mutex_);
            if (answered_) return;
            image_ = std::move(image);
            problems_ = std::move(problems);
            answered_ = true;
        }
        changed_.notify_all();
    }
    // Waits for the image; returns std::nullopt with reasons in `problems` if there will be none.
    std::optional<Image> wait(const std::atomic<bool>& stop, Diagnostics& problems) {
        std::unique_lock lock(mutex_);
        while (!answered_ && !stop)
            changed_.wait_for(lock, std::chrono::milliseconds(20));
        if (stop) cancelled = true;
        problems.append(problems_);
        return std::move(image_);
    }

private:
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    bool answered_ = false;
    std::optional<Image> image_;
    Diagnostics problems_;
};

}  // namespace wrinkle::editor
