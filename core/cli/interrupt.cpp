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

void set_handlers(void (*handler)(int)) {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    for (const int signal : noticed)
        sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
    caught_signal = 0;
    set_handlers(notice);
}

Interruption::~Interruption() {
    set_handlers(SIG_DFL);
}

bool Interruption::requested() {
    return caught_signal != 0;
}

void Interruption::obey() {
    const int signal = caught_signal;
    set_handlers(SIG_DFL);
    raise(signal);
    std::_Exit(128 + signal);
}

}  // namespace wrinkle::cli
