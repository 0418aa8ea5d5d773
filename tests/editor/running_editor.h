// The editor as a process of its own on a virtual screen, and what it says.
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
    // Listens until then, or until it says `word`.
    void listen(Clock::time_point end, const char* word = nullptr);
    // Ends it as it stands; everything that was said before it died.
    const std::string& kill();

private:
    bool take();

    pid_t process_ = -1;
    int output_ = -1;
    std::string said_;
};

}  // namespace wrinkle::editor
