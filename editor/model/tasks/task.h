// Background work, one task at a time: name, progress, cancellation and outcome. The strip above
// the status bar shows it (panels/task_strip.cpp).
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

struct Session;

struct TaskProgress {
    using Clock = std::chrono::steady_clock;
    std::atomic<uint64_t> done = 0, total = 0;            // total 0: not known yet
    std::atomic<Clock::time_point> begun = Clock::now();  // start of counting, for the rate
    std::atomic<bool> cancelled = false;                  // the work must end soon without results

    void begin(uint64_t count) {
        begun = Clock::now();
        total = count;
    }
};

struct TaskOutcome {
    bool good = false;
    std::string sentence;                  // "Wrote strap.glsl."
    Diagnostics warnings = Diagnostics();  // for the problems panel
};

// Runs on a separate thread, so it must own or share all data that it uses.
using TaskWork = std::function<TaskOutcome(TaskProgress&)>;

struct TaskSpec {
    std::string name;  // "Exporting strap.glsl"
    TaskWork work;
    std::function<void()> again;  // starts the same task again
    std::string unit = {};        // counted unit, with a rate: "texels"; "" is steps
    // Called after success on the thread of the interface, once no question is open.
    std::function<void(Session&)> then = {};
};

class Task {
public:
    // `wake` is called on the task's thread at its end.
    Task(TaskSpec order, std::function<void()> wake);
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
    ~Task();  // cancels, and waits for the end

    const TaskSpec& order() const { return order_; }
    const TaskProgress& progress() const { return progress_; }
    void cancel() { progress_.cancelled = true; }
    bool cancelled() const { return progress_.cancelled; }
    bool ended() const { return ended_; }
    TaskOutcome outcome();  // waits for the end

private:
    TaskSpec order_;
    TaskProgress progress_;
    TaskOutcome outcome_;
    std::atomic<bool> ended_ = false;
    std::thread thread_;  // last: it uses all of the above
};

struct Tasks {
    std::function<void()> wake = {};
    std::unique_ptr<Task> running = {};
    // Failure of the last task, shown until it is closed or tried again.
    std::string failed = {};
    std::function<void()> again = {};

    // Warnings of the last task, and the graph in which it ran.
    Diagnostics warnings = Diagnostics();
    std::filesystem::path warnings_of = {};

    bool shown() const { return running || !failed.empty(); }
};

// "412 of 1,024 steps"; with a unit "40 %, 5.2 M texels/s, about 12 s left".
std::string progress_words(uint64_t done, uint64_t total, double seconds, const std::string& unit);

// Returns false, with the reason in the status, while another task runs.
bool start_task(Session& session, TaskSpec order);
void cancel_task(Session& session);
void try_task_again(Session& session);
// Called once a frame: takes the outcome of a task that has ended.
void poll_tasks(Session& session);

}  // namespace wrinkle::editor
