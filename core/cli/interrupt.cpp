#include "cli/interrupt.h"

#include <signal.h>

#include <array>
#include <cstdlib>

namespace wrinkle::cli {
namespace {

volatile sig_atomic_t caught_signal = 0;
constexpr std::array<int, 2> noticed = {SIGINT, SIGTERM};

void notice(int signal) {
    caught_signal = signal;
}

std::array<struct sigaction, noticed.size()> before = {};

}  // namespace

// Ignored signals stay ignored: shells ignore SIGINT for background jobs.
Interruption::Interruption() {
    caught_signal = 0;
    struct sigaction action = {};
    action.sa_handler = notice;
    action.sa_flags = SA_RESTART;
    for (size_t i = 0; i < noticed.size(); ++i) {
        sigaction(noticed[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN) sigaction(noticed[i], &action, nullptr);
    }
}

Interruption::~Interruption() {
    for (size_t i = 0; i < noticed.size(); ++i)
        sigaction(noticed[i], &before[i], nullptr);
}

bool Interruption::requested() {
    return caught_signal != 0;
}

void Interruption::reraise() {
    const int caught = caught_signal;
    signal(caught, SIG_DFL);
    raise(caught);
    std::_Exit(128 + caught);
}

}  // namespace wrinkle::cli
