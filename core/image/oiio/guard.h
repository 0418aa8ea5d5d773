// Helpers of the module's functions: exceptions converted to messages in the caller's buffer, the
// settings of OpenImageIO, and its types in the order of PixelType.
#pragma once

#include <OpenImageIO/imageio.h>

#include <array>
#include <exception>
#include <stdexcept>
#include <string>

#include "image/oiio/image_module.h"
#include "image/oiio/quiet.h"

namespace wrinkle::oiio {

inline constexpr std::array<OIIO::TypeDesc::BASETYPE, 4> types = {
    OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT};

struct Failure : std::runtime_error {
    using runtime_error::runtime_error;
};

std::string sentence(std::string text);  // one line: OpenImageIO's messages may have several
void tell(WrinkleImageText why, const std::string& text);

// Runs `work`; neither exceptions nor output that a library prints leave the module.
template <typename Work>
auto guarded(WrinkleImageText why, Work work) -> decltype(work()) {
    const Quiet quiet;
    try {
        return work();
    } catch (const std::exception& error) {
        tell(why, sentence(error.what()));
    } catch (...) {
        tell(why, "an unknown failure in a library");
    }
    return {};
}

void set_up_once();

}  // namespace wrinkle::oiio
