// The loop of `wrinkle watch`.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wrinkle::cli {

struct WatchOptions {
    std::vector<std::string> words;  // the command and its arguments
    bool poll = false;               // no inotify
    std::optional<int> port;         // page port; none: no page
};

// Runs the command, then again after each change of a file that it reads or looks for, until SIGINT
// or SIGTERM. Prints one line per build, and the errors of a failed one once, unless a file changes
// within 250 ms of the failure. Returns exit_success; exit_usage if the first run refuses its
// arguments; exit_environment if the page or a build cannot be started.
int watch(const WatchOptions& options);

}  // namespace wrinkle::cli
