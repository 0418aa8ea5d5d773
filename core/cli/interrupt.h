// Ctrl-C and the request to end, noticed instead of obeyed: what is half done is cleared away
// first.
#pragma once

namespace wrinkle::cli {

class Interruption {
public:
    Interruption();   // from here on
    ~Interruption();  // as before
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    static bool requested();
    // Ends the program by the signal that was caught, so that its caller sees it.
    [[noreturn]] static void obey();
};

}  // namespace wrinkle::cli
