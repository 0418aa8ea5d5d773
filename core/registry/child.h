// Runs wrinkle-plugin-probe, the process that executes plugin code: a crash of the plugin does not
// end this process.
//
// The process has /dev/null as standard input and outputs, writes its result to a pipe, and
// inherits no other file descriptor. Its process group is killed when it ends or exceeds the time
// limit; the process is killed when this process ends. Its address space is limited to
// `max_child_memory` bytes. This is isolation against mistakes, not against malice: it has the
// rights of the user.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>

namespace wrinkle {

inline constexpr size_t max_child_memory = size_t{4} << 30;   // bytes of address space
inline constexpr size_t max_child_output = size_t{64} << 20;  // bytes

// Exit codes that explain why the process has no result.
enum ChildExit : int {
    child_has_no_output = 113,  // the pipe is closed
    child_output_too_large = 114,
};

struct ProbeResult {
    std::string output;
    bool timed_out = false;
    bool output_too_large = false;
    int signal = 0;  // signal that ended it; 0: it exited
    int exit_code = 0;

    bool is_whole() const {
        return !timed_out && !output_too_large && signal == 0 && exit_code == 0;
    }
};

// Returns std::nullopt and sets `why` if the process cannot be started.
std::optional<ProbeResult> run_child(std::span<const std::string> words,
                                     std::chrono::milliseconds limit, std::string& why);

// Describes how a process without a result ended: "crashed in build(): SIGSEGV (Segmentation
// fault)" with `doing` = "in build()".
std::string ending(const ProbeResult& result, const std::string& doing,
                   std::chrono::milliseconds limit);

}  // namespace wrinkle
