// Work in the background, one at a time: a name, how far it is, a way to stop it, and what came of
// it. The strip above the status bar shows it (panels/task_strip.h).
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <thread>

namespace wrinkle::editor {

struct State;

struct TaskProgress {
    std::atomic<uint64_t> done = 0, total = 0;  // total 0: not known yet
    std::atomic<bool> cancelled = false;        // the work is to end soon, leaving nothing behind
};

struct TaskOutcome {
    bool good = false;
    std::string sentence;  // "Wrote strap.glsl."
};

// Runs on a thread of its own, so it owns or shares all that it touches.
using TaskWork = std::function<TaskOutcome(TaskProgress&)>;

struct TaskOrder {
    std::string name;  // "Exporting strap.glsl"
    TaskWork work;
    std::function<void(State&)> again;  // starts the same once more
};

class Task {
public:
    // wake is called on the thread when it has ended.
    Task(TaskOrder order, std::function<void()> wake);
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
    ~Task();  // cancels, and waits for the end

    const TaskOrder& order() const { return order_; }
    const TaskProgress& progress() const { return progress_; }
    void cancel() { progress_.cancelled = true; }
    bool cancelled() const { return progress_.cancelled; }
    bool ended() const { return ended_; }
    TaskOutcome outcome();  // waits for the end

private:
    TaskOrder order_;
    TaskProgress progress_;
    TaskOutcome outcome_;
    std::atomic<bool> ended_ = false;
    std::thread thread_;  // last: it uses all of the above
};

struct Tasks {
    std::function<void()> wake = {};
    std::unique_ptr<Task> running = {};
    // Of the last one, when it could not be done; shown until it is closed or tried again.
    std::string failed = {};
    std::function<void(State&)> again = {};

    bool shown() const { return running || !failed.empty(); }
};

// False, and why in the status, while another one runs.
bool start_task(State& state, TaskOrder order);
void cancel_task(State& state);
void try_task_again(State& state);
// Once a frame: what came of one that has ended.
void tend_tasks(State& state);

}  // namespace wrinkle::editor
