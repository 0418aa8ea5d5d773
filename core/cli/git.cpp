#include "cli/git.h"

#include <errno.h>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>

#include "base/limits.h"
#include "cli/session.h"

namespace wrinkle::cli {
namespace {

// Reads to the end of the pipe.
std::string read_all(int pipe) {
    std::string text;
    char part[1 << 16];
    ssize_t count = 0;
    while ((count = ::read(pipe, part, sizeof part)) > 0 || (count < 0 && errno == EINTR))
        if (count > 0) text.append(part, static_cast<size_t>(count));
    return text;
}

int exit_code_of(pid_t process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

GitResult run_git(const std::vector<std::string>& words) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return {};
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    std::string program = "git";
    std::vector<char*> arguments{program.data()};
    for (const std::string& word : words)
        arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_t process = -1;
    const int error =
        posix_spawnp(&process, program.c_str(), &files, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    GitResult result;
    if (error == 0) {
        result.output = read_all(ends[0]);
        result.code = exit_code_of(process);
    }
    close(ends[0]);
    return result;
}

std::optional<std::string> read_operand(const std::string& name, Diagnostics& diagnostics) {
    std::error_code error;
    const bool is_revision = name.find(':') != name.npos && !name.starts_with('-') &&
                             !std::filesystem::exists(name, error);
    if (!is_revision) return read_text(name, diagnostics);
    GitResult shown = run_git({"cat-file", "blob", name});
    if (shown.code == 0) return std::move(shown.output);
    diagnostics.add(file_problem(Severity::error, RuleId::file_unreadable, name,
                                 shown.code < 0 ? "cannot be read: git cannot be started"
                                                : "is not a file, and not one of a Git revision",
                                 "a file, or REVISION:PATH"));
    return {};
}

}  // namespace wrinkle::cli
