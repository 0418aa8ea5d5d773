// The module's functions that write; documented in codec.h.
#pragma once

#include <OpenImageIO/imageio.h>

#include "image/codec.h"

namespace wrinkle::oiio {

WrinkleImageWriter* begin_image(const char* path, const char* format, const WriterOptions& options,
                                uint32_t levels, WrinkleImageText why);
int32_t write_rows(WrinkleImageWriter* writer, uint32_t level, const void* pixels, uint32_t first,
                   uint32_t count, WrinkleImageText why);
int32_t end_image(WrinkleImageWriter* writer, WrinkleImageText why);
void drop_image(WrinkleImageWriter* writer);

// Finds a number that begin_image() stored in the file; returns false if there is none.
bool find_number(const OIIO::ImageSpec& spec, const char* name, float& value);

}  // namespace wrinkle::oiio
