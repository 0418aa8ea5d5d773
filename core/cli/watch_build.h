// One run of a command under `wrinkle watch`, in a forked process: it needs no start of a program,
// and a crash or a lack of memory ends only that run.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/file_log.h"

namespace wrinkle::cli {

using WatchClock = std::chrono::steady_clock;

struct BuildOutcome {
    int code = 0;      // exit code; 128 + the signal of a crash
    std::string text;  // standard error
    FileLog files;
    double seconds = 0;  // run time
};

class Build {
public:
    // Forks. Returns std::nullopt and the reason in `why` on failure. Precondition: this process
    // has one thread.
    static std::optional<Build> start(const std::vector<std::string>& words, std::string& why);
    Build(Build&& other) noexcept;
    Build& operator=(Build&& other) noexcept;
    ~Build();  // stops the run and waits for its end

    // Returns the outcome if the run has ended; SIGCHLD announces its end. Precondition: it has
    // not returned an outcome before.
    std::optional<BuildOutcome> outcome();
    // SIGTERM stops a bake and leaves no temporary file; other commands run to their end. SIGKILL
    // stops all.
    void stop(int signal) const;

private:
    Build(pid_t child, int log, int text) : child_(child), log_(log), text_(text) {}

    pid_t child_ = -1;
    int log_ = -1, text_ = -1;  // files in memory
    WatchClock::time_point begun_ = WatchClock::now();
};

}  // namespace wrinkle::cli
