// Worker thread with a queue of one job and one result: a newer job replaces a pending one, and a
// newer result replaces one that was not taken.
//
// `work` and `finish` run on the worker thread; `finish` once, before it ends. `wake` is called
// there after each result with the mutex locked: it may only notify another thread. The worker has
// a lower priority than the thread that draws the interface, for machines with few cores.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace wrinkle::editor {

// Lowers the scheduling priority of the calling thread. Does nothing except on Linux.
void yield_to_interface();

template <class Job, class Result>
class Worker {
public:
    explicit Worker(std::function<Result(Job&&)> work, std::function<void()> wake = {},
                    std::function<void()> finish = {})
        : work_(std::move(work)),
          wake_(std::move(wake)),
          finish_(std::move(finish)),
          thread_([this](const std::stop_token& stop) { run(stop); }) {}

    void post(Job job) {
        {
            const std::lock_guard lock(mutex_);
            job_ = std::move(job);
        }
        changed_.notify_all();
    }
    // Returns the newest result once; std::nullopt if there is none or it was taken.
    std::optional<Result> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(result_, std::nullopt);
    }
    bool idle() const {  // no job is pending or running, and no result is ready
        const std::lock_guard lock(mutex_);
        return !working_ && !job_ && !result_;
    }
    void wait_idle() {  // waits until no job is pending or running
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !working_ && !job_; });
    }

private:
    void run(const std::stop_token& stop) {
        yield_to_interface();
        std::unique_lock lock(mutex_);
        while (changed_.wait(lock, stop, [this] { return job_.has_value(); }) &&
               !stop.stop_requested()) {
            Job job = *std::exchange(job_, std::nullopt);
            working_ = true;
            lock.unlock();
            Result result = work_(std::move(job));
            lock.lock();
            result_ = std::move(result);
            working_ = false;
            changed_.notify_all();
            if (wake_) wake_();
        }
        lock.unlock();
        if (finish_) finish_();
    }

    std::function<Result(Job&&)> work_;
    std::function<void()> wake_, finish_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> job_;
    std::optional<Result> result_;
    bool working_ = false;
    std::jthread thread_;  // declared last: the thread uses all other members
};

}  // namespace wrinkle::editor
