// libpng prints its errors to the C stream `stderr` although OpenImageIO reports them too, and
// offers no way past it. While a Quiet lives, what its own thread prints to `stderr` is dropped;
// the other threads' text still arrives. It also leaves those errors by longjmp, past temporaries
// of OpenImageIO, which a leak checker would count: allocations of the thread are exempt meanwhile.
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
