// Work in the background, one at a time: a name, how far it is, a way to stop it, and what came of
// it. The strip above the status bar shows it (panels/task_strip.h).
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "base/diagnostics.h"

namespace wrinkle::editor {

struct State;

struct TaskProgress {
    using Clock = std::chrono::steady_clock;
    std::atomic<uint64_t> done = 0, total = 0;            // total 0: not known yet
    std::atomic<Clock::time_point> begun = Clock::now();  // counting, for the rate
    std::atomic<bool> cancelled = false;  // the work is to end soon, leaving nothing behind

    void begin(uint64_t count) {
        begun = Clock::now();
        total = count;
    }
};

struct TaskOutcome {
    bool good = false;
    std::string sentence;                  // "Wrote strap.glsl."
    Diagnostics warnings = Diagnostics();  // for the list of problems
};

// Runs on a thread of its own, so it owns or shares all that it touches.
using TaskWork = std::function<TaskOutcome(TaskProgress&)>;

struct TaskOrder {
    std::string name;  // "Exporting strap.glsl"
    TaskWork work;
    std::function<void(State&)> again;  // starts the same once more
    std::string unit = {};              // that is counted, with a rate: "texels"; "" is steps
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

    // What the last one had to tell, and in which graph it ran.
    Diagnostics warnings = Diagnostics();
    std::filesystem::path warnings_of = {};

    bool shown() const { return running || !failed.empty(); }
};

// "412 of 1,024 steps"; where a unit is counted "40 %, 5.2 M texels/s, about 12 s left".
std::string progress_words(uint64_t done, uint64_t total, double seconds, const std::string& unit);

// False, and why in the status, while another one runs.
bool start_task(State& state, TaskOrder order);
void cancel_task(State& state);
void try_task_again(State& state);
// Once a frame: what came of one that has ended.
void tend_tasks(State& state);

}  // namespace wrinkle::editor
