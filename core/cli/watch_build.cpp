#include "cli/watch_build.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

#include "base/temporary.h"
#include "cli/cli.h"

namespace wrinkle::cli {
namespace {

// A handler, because ignored signals would stay ignored by commands that can be interrupted.
void run_on(int) {}

[[noreturn]] void run_child(const std::vector<std::string>& words, int log, int text,
                            pid_t parent) {
    struct sigaction action = {};
    action.sa_handler = run_on;
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM})
        sigaction(signal, &action, nullptr);
    signal(SIGCHLD, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(0);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, STDIN_FILENO);
    dup2(text, STDERR_FILENO);
    start_file_log(log);
    const int code = run_words(words);
    std::fflush(stderr);
    _exit(code);
}

}  // namespace

std::optional<Build> Build::start(const std::vector<std::string>& words, std::string& why) {
    std::fflush(nullptr);  // else the child would print it too
    Build build(-1, memfd_create("files", MFD_CLOEXEC), memfd_create("text", MFD_CLOEXEC));
    const pid_t parent = getpid();
    if (build.log_ >= 0 && build.text_ >= 0) build.child_ = fork();
    if (build.child_ == 0) run_child(words, build.log_, build.text_, parent);
    if (build.child_ > 0) return build;
    why = last_error().message();
    return {};
}

Build::Build(Build&& other) noexcept
    : child_(std::exchange(other.child_, -1)),
      log_(std::exchange(other.log_, -1)),
      text_(std::exchange(other.text_, -1)),
      begun_(other.begun_) {}

Build& Build::operator=(Build&& other) noexcept {
    std::swap(child_, other.child_);
    std::swap(log_, other.log_);
    std::swap(text_, other.text_);
    std::swap(begun_, other.begun_);
    return *this;
}

Build::~Build() {
    if (child_ > 0) {
        stop(SIGTERM);
        waitpid(child_, nullptr, 0);
    }
    for (const int file : {log_, text_})
        if (file >= 0) close(file);
}

std::optional<BuildOutcome> Build::outcome() {
    int status = 0;
    if (waitpid(child_, &status, WNOHANG) != child_) return {};
    child_ = -1;
    BuildOutcome outcome;
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    outcome.text = bytes_of_descriptor(text_);
    outcome.files = read_file_log(log_);
    outcome.seconds = std::chrono::duration<double>(WatchClock::now() - begun_).count();
    return outcome;
}

void Build::stop(int signal) const {
    if (child_ > 0) kill(child_, signal);
}

}  // namespace wrinkle::cli
