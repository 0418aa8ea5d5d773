// Suppresses a thread's output to the C stream `stderr` during its lifetime; the output of other
// threads is not affected. Required for libpng, which prints errors that OpenImageIO reports anyway
// and has no option against it. libpng also returns from errors by longjmp, which leaks temporaries
// of OpenImageIO, so the thread's allocations are exempt from leak checking meanwhile.
#pragma once

namespace wrinkle {

class Quiet {
public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

}  // namespace wrinkle
