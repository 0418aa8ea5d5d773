/* Interface of a codec: a table of functions that read and write image files. core/image/png has
 * that of PNG, by libpng; the module core/image/oiio has that of the other formats, by OpenImageIO,
 * and for writing OpenEXR files by OpenEXR's own library.
 *
 * The module exports one symbol, wrinkle_image_module, which returns its table. Rows are ordered
 * top to bottom as in files, values have the file's own type. Both sides may use different
 * allocators: neither frees or grows memory of the other, so messages are written to the caller's
 * buffer. No exception leaves a codec. All functions are thread-safe; only one thread at a time may
 * use a reader or writer.
 */
#pragma once

#include <cstdint>

#include "image/writer.h"

#define WRINKLE_IMAGE_MODULE_VERSION 5u
#define WRINKLE_IMAGE_MODULE_SYMBOL "wrinkle_image_module"

struct WrinkleImageReader; /* opaque: each codec defines its own */
struct WrinkleImageWriter;

struct WrinkleImageHeader {
    uint32_t width;
    uint32_t height;
    uint32_t channels;  /* 1 to 4: as read() returns */
    uint32_t has_alpha; /* the last channel is alpha */
    uint32_t type;      /* PixelType: 0 u8, 1 u16, 2 half, 3 float */
};

/* Error message of one sentence, truncated to `capacity`, always terminated. */
struct WrinkleImageText {
    char* text;
    uint32_t capacity;
};

struct WrinkleImageCodec {
    uint32_t size; /* size of this struct in the codec */
    uint32_t version;
    /* Reads the header of a file of format `format`; returns NULL and the reason on failure. An
     * OpenEXR file wider or higher than `max_side` is refused, with its size in `header`. */
    WrinkleImageReader* (*open)(const char* path, const char* format, uint32_t max_side,
                                WrinkleImageHeader* header, WrinkleImageText why);
    /* Returns the number of rows per read(): a row of tiles, or some scan lines. */
    uint32_t (*band)(const WrinkleImageReader* reader);
    /* Decodes width * count * channels values of header.type; returns 0 and the reason on failure.
     * `first` is a multiple of band(), and so is `count` unless it reaches the last row; bands are
     * read in order. */
    int32_t (*read)(WrinkleImageReader* reader, uint32_t first, uint32_t count, void* pixels,
                    WrinkleImageText why);
    void (*close)(WrinkleImageReader* reader);
    /* Reads a number that the writer below stored in a file; returns 0 if there is none. */
    int32_t (*number)(const char* path, const char* format, uint32_t max_side, const char* name,
                      float* value);
    /* Opens a file of format "png", "jpeg", "tiff", "openexr" or "hdr" for writing; returns NULL
     * and the reason on failure. `levels` is 1 without mips. If this or a function below fails, the
     * caller removes the file. */
    WrinkleImageWriter* (*begin)(const char* path, const char* format,
                                 const wrinkle::WriterOptions& options, uint32_t levels,
                                 WrinkleImageText why);
    /* Writes `count` rows of a mip level from row `first` on, in order for each level; interleaved,
     * of options.type. `count` is a multiple of the tile side, or of 64 for scan lines, or reaches
     * the last row. */
    int32_t (*rows)(WrinkleImageWriter* writer, uint32_t level, const void* pixels, uint32_t first,
                    uint32_t count, WrinkleImageText why);
    /* Completes the file after all rows; destroys the writer. */
    int32_t (*end)(WrinkleImageWriter* writer, WrinkleImageText why);
    void (*drop)(WrinkleImageWriter* writer); /* instead of end() */
};

using WrinkleImageCodecEntry = const WrinkleImageCodec* (*)();
