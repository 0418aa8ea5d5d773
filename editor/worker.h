// A thread that works on the newest job it was given: one job waits at most, a newer one takes its
// place. Results come out one at a time, the newest only.
//
// Work and finish run on the thread, finish once before it ends. wake is called there after each
// result; it may do no more than tell another thread to look. Where there are fewer cores than
// threads the one that draws the interface goes first.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace wrinkle::editor {

// Makes the calling thread give way to those that have not called this; on Linux alone.
void yield_to_interface();

template <class Job, class Result>
class Worker {
public:
    Worker(std::function<Result(Job&&)> work, std::function<void()> wake,
           std::function<void()> finish = {})
        : work_(std::move(work)),
          wake_(std::move(wake)),
          finish_(std::move(finish)),
          thread_([this] { run(); }) {}
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker() {
        {
            const std::lock_guard lock(mutex_);
            stopping_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }

    void post(Job job) {
        {
            const std::lock_guard lock(mutex_);
            job_ = std::move(job);
        }
        changed_.notify_all();
    }
    // A result that has not been taken yet.
    std::optional<Result> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(result_, std::nullopt);
    }
    bool busy() const {  // a job waits or is being worked on
        const std::lock_guard lock(mutex_);
        return working_ || job_;
    }
    bool idle() const {  // neither that nor a result to take
        const std::lock_guard lock(mutex_);
        return !working_ && !job_ && !result_;
    }
    void settle() {  // until it is no longer busy
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return !working_ && !job_; });
    }

private:
    void run() {
        yield_to_interface();
        std::unique_lock lock(mutex_);
        while (true) {
            changed_.wait(lock, [this] { return stopping_ || job_; });
            if (stopping_) break;
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
    std::condition_variable changed_;
    std::optional<Job> job_;
    std::optional<Result> result_;
    bool working_ = false, stopping_ = false;
    std::thread thread_;  // last: it uses all of the above
};

}  // namespace wrinkle::editor
