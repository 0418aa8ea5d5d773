// Long work: the progress of a bake in texels, its interruption by a signal, and notices of slow
// steps.
//
// Progress is one line that is overwritten on a terminal, JSON lines for tools, or no output in a
// pipe.
//
//   {"done": 131072, "total": 1048576, "per_second": 5.2e7, "seconds_left": 0.02}
#pragma once

#include <chrono>
#include <cstdint>
#include <stop_token>
#include <string>
#include <thread>

namespace wrinkle::cli {

class Progress {
public:
    enum class Form : uint8_t { none, line, json };

    Progress(Form form, uint64_t total) : form_(form), total_(total) {}
    ~Progress();  // clears the line
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    static Form form_for(bool json);  // `line` if standard error is a terminal

    // Counts work that an earlier run finished; it does not affect the rate.
    void skip(uint64_t count);
    void add(uint64_t count);

private:
    using Clock = std::chrono::steady_clock;
    void show(double seconds) const;

    Form form_;
    uint64_t total_, done_ = 0, skipped_ = 0;
    Clock::time_point begun_ = Clock::now(), shown_{};
};

// Shows the seconds that a step without progress takes, if it takes more than two: one line on a
// terminal, which the destructor clears; no output in a pipe.
class SlowStep {
public:
    explicit SlowStep(std::string name);  // "compiling the shader"
    ~SlowStep();
    SlowStep(const SlowStep&) = delete;
    SlowStep& operator=(const SlowStep&) = delete;

private:
    void show(const std::stop_token& stop) const;

    std::string name_;
    std::jthread thread_;
};

// Catches SIGINT (Ctrl-C) and SIGTERM from now on, so that a command can clean up unfinished work
// before it ends.
void catch_interruption();
bool is_interrupted();
// Raises the caught signal again with the default action, so that the parent process sees it.
[[noreturn]] void reraise_interruption();

}  // namespace wrinkle::cli
