// OpenImageIO's settings and types.
#pragma once

#include <OpenImageIO/imageio.h>

#include <array>

namespace wrinkle::oiio {

// By PixelType.
inline constexpr std::array<OIIO::TypeDesc::BASETYPE, 4> types = {
    OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT};

// Sets OpenImageIO's global attributes on the first call: no threads and no size limit, because the
// caller has both, and half floats in TIFF. Thread-safe.
void set_up_once();

}  // namespace wrinkle::oiio
