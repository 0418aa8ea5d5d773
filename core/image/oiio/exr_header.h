// Checks the sizes in the header of an OpenEXR file before the file is opened: OpenEXR's C++
// library, which OpenImageIO uses, allocates what the attributes and the data window ask for.
//
// OpenEXR's C library does not replace this check: it skips damaged attributes, and then reads
// other sizes than the C++ library. Layout: openexr.com, "OpenEXR File Layout".
#pragma once

#include <cstdint>

namespace wrinkle::oiio {

struct ExrSize {
    int64_t width = 0, height = 0;  // of the largest data window
};

// Throws Failure where an attribute is larger than the rest of the file.
ExrSize size_of_exr(const char* path);

}  // namespace wrinkle::oiio
