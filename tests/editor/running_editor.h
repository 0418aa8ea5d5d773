// The editor as a child process on a virtual screen, with its output.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "virtual_screen.h"

namespace wrinkle::editor {

class RunningEditor {
public:
    using Clock = std::chrono::steady_clock;

    RunningEditor(const VirtualScreen& screen, const std::vector<std::string>& arguments);
    RunningEditor(const RunningEditor&) = delete;
    RunningEditor& operator=(const RunningEditor&) = delete;
    ~RunningEditor();

    pid_t process() const { return process_; }
    // Reads the output until `end`, until it contains `word` or until it is closed.
    void listen(Clock::time_point end, const char* word = nullptr);
    // Kills the process with SIGKILL; returns its complete output.
    const std::string& kill();

private:
    bool take();

    pid_t process_ = -1;
    int output_ = -1;
    std::string said_;
};

}  // namespace wrinkle::editor
