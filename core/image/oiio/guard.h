// Helpers of the module's functions: exceptions converted to messages in the caller's buffer, no
// output of libraries, the settings of OpenImageIO, and its types in the order of PixelType.
#pragma once

#include <OpenImageIO/imageio.h>

#include <array>
#include <exception>
#include <stdexcept>
#include <string>

#include "image/oiio/image_module.h"

namespace wrinkle::oiio {

inline constexpr std::array<OIIO::TypeDesc::BASETYPE, 4> types = {
    OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT};

struct Failure : std::runtime_error {
    using runtime_error::runtime_error;
};

std::string sentence(std::string text);  // one line: OpenImageIO's messages may have several
void set_text(WrinkleImageText why, const std::string& text);

// Suppresses a thread's output to the C stream `stderr` during its lifetime; the output of other
// threads is not affected. Required for libpng, which prints errors that OpenImageIO reports anyway
// and has no option against it. libpng also returns from errors by longjmp, which leaks temporaries
// of OpenImageIO, so the thread's allocations are exempt from leak checking meanwhile.
class Quiet {
public:
    Quiet();
    ~Quiet();
    Quiet(const Quiet&) = delete;
    Quiet& operator=(const Quiet&) = delete;
};

// Runs `work`; neither exceptions nor output that a library prints leave the module.
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

void set_up_once();

}  // namespace wrinkle::oiio
