// An image of the preview in a given size: one thread requests it, the preview's thread draws it.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
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

    bool answered() const { return answered_; }
    // Called by the preview: sets the image, or std::nullopt with the reasons.
    void answer(std::optional<Image> image, Diagnostics problems) {
        if (!answered_.exchange(true)) answer_.set_value({std::move(image), std::move(problems)});
    }
    // Waits for the image; returns std::nullopt with reasons in `problems` if there will be none.
    std::optional<Image> wait(const std::atomic<bool>& stop, Diagnostics& problems) {
        std::future<Answer> future = answer_.get_future();
        while (!stop && future.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready)
            continue;
        cancelled = stop.load();
        if (stop) return std::nullopt;
        Answer answer = future.get();
        problems.append(answer.problems);
        return std::move(answer.image);
    }

private:
    struct Answer {
        std::optional<Image> image;
        Diagnostics problems;
    };
    std::atomic<bool> answered_ = false;
    std::promise<Answer> answer_;
};

}  // namespace wrinkle::editor
