// Wrapper of the image module's functions: converts exceptions to messages in the caller's buffer
// (`why`) and suppresses the libraries' output to stderr. Also OpenImageIO's settings and types.
#pragma once

#include <OpenImageIO/imageio.h>

#include <array>
#include <exception>
#include <stdexcept>
#include <string>

#include "image/oiio/image_module.h"

namespace wrinkle::oiio {

// By PixelType.
inline constexpr std::array<OIIO::TypeDesc::BASETYPE, 4> types = {
    OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT};

struct Failure : std::runtime_error {
    using runtime_error::runtime_error;
};

// Returns an error message as one line; a default message if it is empty.
std::string sentence(std::string text);
// Copies the text to the caller's buffer, truncated to its capacity.
void set_text(WrinkleImageText why, const std::string& text);

// Suppresses a thread's output to the C stream `stderr` during its lifetime; the output of other
// threads is not affected. May be nested. Required for libpng, which prints errors that OpenImageIO
// reports anyway and has no option against it. libpng also returns from errors by longjmp, which
// leaks temporaries of OpenImageIO, so the thread's allocations are exempt from leak checking
// meanwhile.
class Quiet {
public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

// Returns the result of `work`. If it throws, writes the message to `why` and returns a
// value-initialised result.
template <typename Work>
auto guarded(WrinkleImageText why, Work work) -> decltype(work()) {
    const Quiet quiet;
    try {
        return work();
    } catch (const std::exception& error) {
        set_text(why, sentence(error.what()));
    } catch (...) {
        set_text(why, "an unknown failure in a library");
    }
    return {};
}

// Sets OpenImageIO's global attributes on the first call; thread-safe.
void set_up_once();

}  // namespace wrinkle::oiio
