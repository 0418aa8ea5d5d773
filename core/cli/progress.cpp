#include "cli/progress.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <utility>

#include "base/text.h"

namespace wrinkle::cli {
namespace {

constexpr double seconds_between_lines = 0.1;

volatile sig_atomic_t caught_signal = 0;

}  // namespace

Progress::~Progress() {
    if (form_ == Form::line) std::fputs("\r\x1b[K", stderr);
}

Progress::Form Progress::form_for(bool json) {
    if (json) return Form::json;
    return isatty(STDERR_FILENO) ? Form::line : Form::none;
}

void Progress::skip(uint64_t count) {
    skipped_ += count;
    done_ += count;
}

void Progress::add(uint64_t count) {
    done_ += count;
    if (form_ == Form::none) return;
    const Clock::time_point now = Clock::now();
    const auto since = [&](Clock::time_point then) {
        return std::chrono::duration<double>(now - then).count();
    };
    if (form_ == Form::line && since(shown_) < seconds_between_lines) return;
    shown_ = now;
    show(std::max(since(begun_), 1e-6));
}

void Progress::show(double seconds) const {
    const double rate = static_cast<double>(done_ - skipped_) / seconds;
    const double left = static_cast<double>(total_ - done_) / std::max(rate, 1e-6);
    if (form_ == Form::json) {
        std::printf("{\"done\": %llu, \"total\": %llu, \"per_second\": %s, \"seconds_left\": %s}\n",
                    static_cast<unsigned long long>(done_), static_cast<unsigned long long>(total_),
                    shortest(static_cast<float>(rate)).c_str(),
                    shortest(static_cast<float>(left)).c_str());
        std::fflush(stdout);
        return;
    }
    const double part =
        static_cast<double>(done_) / static_cast<double>(std::max<uint64_t>(total_, 1));
    std::fprintf(stderr, "\r\x1b[K%3.0f %%, %stexels/s, %s left", 100 * part,
                 rough_count(rate).c_str(), rough_duration(left).c_str());
}

SlowStep::SlowStep(std::string name) : name_(std::move(name)) {
    if (isatty(STDERR_FILENO))
        thread_ = std::jthread([this](const std::stop_token& stop) { show(stop); });
}

SlowStep::~SlowStep() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

void SlowStep::show(const std::stop_token& stop) const {
    constexpr int first = 2;
    std::mutex mutex;
    std::condition_variable_any stopped;
    std::unique_lock lock(mutex);
    int seconds = 0;
    while (!stopped.wait_for(lock, stop, std::chrono::seconds(1),
                             [&] { return stop.stop_requested(); }))
        if (++seconds >= first)
            std::fprintf(stderr, "\r\x1b[K%s: %d s (Ctrl-C stops)", name_.c_str(), seconds);
    if (seconds >= first) std::fputs("\r\x1b[K", stderr);
}

// Ignored signals stay ignored: shells ignore SIGINT for background jobs.
void catch_interruption() {
    struct sigaction action = {}, before = {};
    action.sa_handler = [](int signal) { caught_signal = signal; };
    action.sa_flags = SA_RESTART;
    for (const int signal : {SIGINT, SIGTERM}) {
        sigaction(signal, nullptr, &before);
        if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
    }
}

bool is_interrupted() {
    return caught_signal != 0;
}

void reraise_interruption() {
    const int caught = caught_signal;
    signal(caught, SIG_DFL);
    raise(caught);
    std::_Exit(128 + caught);
}

}  // namespace wrinkle::cli
