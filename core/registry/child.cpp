#include "registry/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <vector>

#include "base/folders.h"
#include "base/text.h"
#include "registry/probe.h"

namespace wrinkle {
namespace {

using Clock = std::chrono::steady_clock;

struct Process {
    pid_t id = -1;
    int output = -1;
    int error = 0;  // not 0: no process was started
};

Process start(const std::string& program, std::span<const std::string> words) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return {.error = errno};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        posix_spawn_file_actions_addopen(&files, file, "/dev/null", O_RDWR, 0);
    posix_spawn_file_actions_adddup2(&files, ends[1], probe_output);
    posix_spawn_file_actions_addclosefrom_np(&files, probe_output + 1);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    std::vector<char*> arguments{const_cast<char*>(program.c_str())};
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    Process process{.output = ends[0]};
    process.error =
        posix_spawn(&process.id, program.c_str(), &files, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    fcntl(process.output, F_SETFL, O_NONBLOCK);
    return process;
}

// If this program ignores SIGCHLD the exit status is lost (ECHILD); the result then depends only on
// the output.
bool has_ended(const Process& process, ProbeResult& result) {
    siginfo_t how{};
    const int failed =
        waitid(P_PID, static_cast<id_t>(process.id), &how, WEXITED | WNOHANG | WNOWAIT);
    if (failed != 0 && errno == ECHILD) return true;
    if (how.si_pid != process.id) return false;
    (how.si_code == CLD_EXITED ? result.exit_code : result.signal) = how.si_status;
    return true;
}

// Returns false at the end of the output, on an error, or beyond max_child_output; true if more may
// come.
bool take(const Process& process, std::string& output) {
    char part[1 << 16];
    ssize_t count = 0;
    while ((count = read(process.output, part, sizeof part)) > 0 &&
           output.size() <= max_child_output)
        output.append(part, static_cast<size_t>(count));
    return count < 0 && (errno == EAGAIN || errno == EINTR);
}

ProbeResult finish(const Process& process, std::chrono::milliseconds limit) {
    ProbeResult result;
    const auto end = Clock::now() + limit;
    bool open = true;
    while (!has_ended(process, result)) {
        result.timed_out = Clock::now() >= end;
        result.output_too_large = result.output.size() > max_child_output;
        if (result.timed_out || result.output_too_large) break;
        pollfd waiting{open ? process.output : -1, POLLIN, 0};
        poll(&waiting, 1, 10);  // milliseconds: the process may end with its output open
        open = open && take(process, result.output);
    }
    kill(-process.id, SIGKILL);  // before waitpid(), while the group id cannot be reused
    while (waitpid(process.id, nullptr, 0) < 0 && errno == EINTR) {
    }
    if (open) take(process, result.output);  // once: a child that left the group may hold it open
    return result;
}

std::string signal_text(int number) {
    const char* name = sigabbrev_np(number);
    const char* words = sigdescr_np(number);
    return (name ? "SIG" + std::string(name) : "signal " + std::to_string(number)) +
           (words ? " (" + std::string(words) + ")" : "");
}

}  // namespace

std::optional<ProbeResult> run_child(std::span<const std::string> words,
                                     std::chrono::milliseconds limit, std::string& why) {
    const std::string program = installation_folder() / "lib/wrinkle/wrinkle-plugin-probe";
    const Process process = start(program, words);
    std::optional<ProbeResult> result;
    if (process.error == 0)
        result = finish(process, limit);
    else
        why = program + ": " + strerror(process.error);
    close(process.output);
    return result;
}

std::string ending(const ProbeResult& result, const std::string& doing,
                   std::chrono::milliseconds limit) {
    if (result.timed_out)
        return "hung " + doing + ": it was ended after " +
               shortest(std::chrono::duration<double>(limit).count()) + " s";
    if (result.signal != 0) return "crashed " + doing + ": " + signal_text(result.signal);
    if (result.exit_code == child_has_no_output) return "closed the files of its process " + doing;
    return "ended the program " + doing + ", with exit code " + std::to_string(result.exit_code);
}

}  // namespace wrinkle
