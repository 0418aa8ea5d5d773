// Checks the sizes in the header of an OpenEXR file before the file is opened: OpenEXR's C++
// library, which OpenImageIO uses, allocates memory for the sizes of the attributes and the data
// window.
//
// OpenEXR's C library does not replace this check: it skips damaged attributes, and then reads
// other sizes than the C++ library. Layout: openexr.com, "OpenEXR File Layout".
#pragma once

#include <cstdint>

namespace wrinkle::oiio {

struct ExrSize {
    int64_t width = 0, height = 0;  // maximum of all data windows
};

// Throws Failure if an attribute is larger than the rest of the file.
ExrSize size_of_exr(const char* path);

}  // namespace wrinkle::oiio
