#include "cli/watch_loop.h"

#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include "base/folder_watch.h"
#include "base/printable.h"
#include "cli/output.h"
#include "cli/test_report.h"
#include "cli/watch_build.h"
#include "cli/watch_inputs.h"
#include "cli/watch_page.h"

namespace wrinkle::cli {
namespace {

using namespace std::chrono_literals;
using Time = WatchClock::time_point;
using Delay = WatchClock::duration;

// A save is several events; a build starts when they pause, and at the latest after the second.
constexpr Delay pause_of_events = 20ms, longest_save = 100ms;
// A failure is reported if the files are the same at these times after it: programs that replace a
// file in steps leave it missing or incomplete for a moment.
constexpr Delay first_check = 50ms, second_check = 250ms;
constexpr Delay between_polls = 100ms;

volatile sig_atomic_t signals_caught = 0;

void say(const std::string& text) {
    std::fprintf(stderr, "wrinkle: %s\n", text.c_str());
}

std::string names_of(const std::vector<std::filesystem::path>& files) {
    constexpr size_t max_names = 3;
    std::string text;
    for (size_t i = 0; i < files.size() && i < max_names; ++i)
        text += (i ? ", " : "") + printable(files[i].string());
    if (files.size() > max_names)
        text += " and " + std::to_string(files.size() - max_names) + " more";
    return text;
}

// Prints the outcomes of builds: errors once, one line per build.
class BuildReport {
public:
    // Returns the line of the build.
    std::string add(const BuildOutcome& outcome) {
        if (outcome.text != shown_) std::fputs(outcome.text.c_str(), stderr);
        const bool repeated = outcome.code != 0 && failing_ && outcome.text == shown_;
        shown_ = outcome.text;
        char time[32];
        std::snprintf(time, sizeof time, " (%.0f ms)", outcome.seconds * 1000);
        const std::string result =
            outcome.code == 0 ? (failing_ ? "fixed; " : "") + result_of(outcome.files)
                              : (repeated ? "failed as before" : "failed") + ending(outcome.code);
        failing_ = outcome.code != 0;
        say(result + time);
        return result + time;
    }

private:
    static std::string ending(int code) {
        return code > 128 ? " by signal " + std::to_string(code - 128) : "";
    }
    static std::string result_of(const FileLog& files) {
        if (!files.replaced.empty()) return "wrote " + names_of(files.replaced);
        return files.outputs.empty() ? "done" : "the output is the same";
    }

    std::string shown_;  // text of the last build
    bool failing_ = false;
};

class Loop {
public:
    explicit Loop(const WatchOptions& options) : options_(options) {}

    int run() {
        if (options_.port) {
            page_ = WatchPage::start(*options_.port, why_);
            if (!page_) return fail(exit_environment, why_);
            say("shows http://localhost:" + std::to_string(page_->port()));
        }
        catch_signals();
        if (!options_.poll) {
            std::string why;
            folders_ = FolderWatch::make(why);
            if (!folders_) say("polls the files, because they cannot be watched: " + why);
        }
        while (!end_ && signals_caught == 0)
            if (!step()) return fail(exit_environment, why_);
        wait_for_build();
        return end_.value_or(exit_success);
    }

private:
    // SIGCHLD and the signals that end the loop are delivered during ppoll() only.
    void catch_signals() {
        struct sigaction action = {}, before = {};
        sigset_t blocked;
        sigemptyset(&blocked);
        for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) {
            sigaction(signal, nullptr, &before);
            if (before.sa_handler == SIG_IGN && signal == SIGINT) continue;
            action.sa_handler =
                signal == SIGCHLD ? [](int) {} : [](int) { signals_caught = signals_caught + 1; };
            sigaction(signal, &action, nullptr);
            sigaddset(&blocked, signal);
        }
        sigprocmask(SIG_BLOCK, &blocked, &unblocked_);
    }

    // Returns false and sets why_ if a build cannot be started.
    bool step() {
        if (!build_ && (is_first_ || changed_)) {
            changed_ = false;
            held_.reset();
            build_ = Build::start(options_.words, why_);
            if (!build_) return false;
        }
        wait();
        if (folders_ && folders_->take_events()) add_event();
        const Time now = WatchClock::now();
        if (is_settled(now)) look_at_files();
        if (!folders_ && now >= next_poll_) look_at_files();
        if (changed_ && build_) build_->stop(SIGTERM);
        if (auto outcome = build_ ? build_->outcome() : std::nullopt) finish(std::move(*outcome));
        if (held_ && now >= held_->check) check_held();
        return true;
    }

    void wait() {
        std::optional<Time> until;
        const auto add = [&](Time time) { until = until ? std::min(*until, time) : time; };
        if (first_event_) add(settles_at());
        if (!folders_) add(next_poll_);
        if (held_) add(held_->check);
        if (changed_ && !build_) return;
        pollfd events = {folders_ ? folders_->descriptor() : -1, POLLIN, 0};
        timespec timeout = {};
        if (until) {
            const auto left = std::max<Delay>(*until - WatchClock::now(), 0ms);
            timeout.tv_sec = std::chrono::duration_cast<std::chrono::seconds>(left).count();
            timeout.tv_nsec = std::chrono::nanoseconds(left % 1s).count();
        }
        ppoll(&events, 1, until ? &timeout : nullptr, &unblocked_);
    }

    void add_event() {
        last_event_ = WatchClock::now();
        if (!first_event_) first_event_ = last_event_;
    }
    Time settles_at() const {
        return std::min(last_event_ + pause_of_events, *first_event_ + longest_save);
    }
    bool is_settled(Time now) const { return first_event_ && now >= settles_at(); }

    void look_at_files() {
        first_event_.reset();
        next_poll_ = WatchClock::now() + between_polls;
        if (is_first_) return;  // its inputs are compared at its end
        watch_folders();
        changed_ |= inputs_.changed();
    }

    // A failed watch turns to polling.
    void watch_folders() {
        std::string why;
        if (!folders_ || folders_->watch(inputs_.files(), why)) return;
        say("polls the files, because they cannot be watched: " + why);
        folders_.reset();
        next_poll_ = WatchClock::now();
    }

    void finish(BuildOutcome outcome) {
        build_.reset();
        const bool failed = outcome.code != exit_success, is_first = is_first_;
        is_first_ = false;
        inputs_.set(outcome.files, !failed);
        watch_folders();
        changed_ |= inputs_.read();
        if (is_first && outcome.code == exit_usage) {
            std::fputs(outcome.text.c_str(), stderr);
            end_ = exit_usage;
        } else if (is_first) {
            report(outcome);
            say("watches " + std::to_string(inputs_.files().size()) + " files; Ctrl-C stops");
        } else if (!failed) {
            report(outcome);
        } else if (!changed_) {
            const Time now = WatchClock::now();
            held_ = Held{std::move(outcome), now + first_check, now + second_check};
        }
    }

    void report(const BuildOutcome& outcome) {
        const std::string line = report_.add(outcome);
        std::vector<std::filesystem::path> made = outcome.files.distinct_outputs();
        // A test run that fails has a report too; its page contains its images.
        const bool is_test = options_.words[0] == "test";
        if (is_test)
            std::erase_if(made, [](const auto& file) { return file.filename() != page_file; });
        const bool ok = outcome.code == 0, shows_made = ok || (is_test && !made.empty());
        if (shows_made) outputs_ = std::move(made);
        if (page_) page_->send({ok, options_.words[0], line, outcome.text, outputs_, shows_made});
    }

    void check_held() {
        look_at_files();
        if (changed_) return;
        if (held_->check == held_->report) {
            report(held_->outcome);
            held_.reset();
        } else {
            held_->check = held_->report;
        }
    }

    // A second signal ends a build that cannot be interrupted.
    void wait_for_build() {
        while (build_ && !build_->outcome()) {
            build_->stop(signals_caught > 1 ? SIGKILL : SIGTERM);
            ppoll(nullptr, 0, nullptr, &unblocked_);
        }
    }

    struct Held {
        BuildOutcome outcome;  // a failure
        Time check, report;
    };

    const WatchOptions& options_;
    sigset_t unblocked_ = {};
    std::optional<FolderWatch> folders_;  // none: polls
    WatchedInputs inputs_;
    BuildReport report_;
    std::optional<WatchPage> page_;
    std::vector<std::filesystem::path> outputs_;  // that the page shows
    std::optional<Build> build_;
    std::optional<Held> held_;
    std::optional<Time> first_event_;
    Time last_event_, next_poll_;
    bool is_first_ = true, changed_ = false;
    std::optional<int> end_;
    std::string why_;
};

}  // namespace

int watch(const WatchOptions& options) {
    return Loop(options).run();
}

}  // namespace wrinkle::cli
