// Runs wrinkle-plugin-probe, the process in which code of plugins runs: what that code does to its
// process does not end this one.
//
// The process has /dev/null as standard input and outputs, writes its result to a pipe, and has no
// other file of this process. It is ended with all that it started when it takes longer than the
// limit, or when this process ends. It may have `max_child_memory` bytes of memory. It is a guard
// against mistakes, not against malice: it has the rights of who runs it.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>

namespace wrinkle {

inline constexpr size_t max_child_memory = size_t{4} << 30;   // bytes of address space
inline constexpr size_t max_child_output = size_t{64} << 20;  // bytes

// The exit codes that say why the process has no result.
enum ChildExit : int {
    child_has_no_output = 113,  // the pipe is closed
    child_output_too_large = 114,
};

struct ChildResult {
    std::string output;
    bool late = false;
    bool too_large = false;
    int signal = 0;  // that ended it; 0: it exited
    int exit_code = 0;

    bool is_whole() const { return !late && !too_large && signal == 0 && exit_code == 0; }
};

// Nothing, with the reason in `why`, when the process cannot be started.
std::optional<ChildResult> run_child(std::span<const std::string> words,
                                     std::chrono::milliseconds limit, std::string& why);

// How a process ended that gave no result: "crashed in build(): SIGSEGV (Segmentation fault)", with
// `doing` = "in build()".
std::string ending(const ChildResult& result, const std::string& doing,
                   std::chrono::milliseconds limit);

}  // namespace wrinkle
