// Catches SIGINT (Ctrl-C) and SIGTERM, so that a command can clean up unfinished work before it
// ends.
#pragma once

namespace wrinkle::cli {

class Interruption {
public:
    Interruption();   // installs the handlers
    ~Interruption();  // restores the previous handlers
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    static bool requested();
    // Raises the caught signal again with the default action, so that the parent process sees it.
    [[noreturn]] static void reraise();
};

}  // namespace wrinkle::cli
