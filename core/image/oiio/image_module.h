/* Interface between core/image and the module that contains OpenImageIO, and OpenEXR's own library
 * for writing OpenEXR files.
 *
 * The module exports one symbol, wrinkle_image_module, which returns a table of functions. Only
 * plain data is passed: rows are ordered top to bottom as in files, values have the file's own
 * type, messages are written to the caller's buffer, and no exception leaves the module. All
 * functions are thread-safe; only one thread at a time may use a reader or writer.
 */
#ifndef WRINKLE_IMAGE_MODULE_H
#define WRINKLE_IMAGE_MODULE_H

#include <stdint.h>

#define WRINKLE_IMAGE_MODULE_VERSION 4u
#define WRINKLE_IMAGE_MODULE_SYMBOL "wrinkle_image_module"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct WrinkleImageReader WrinkleImageReader; /* opaque */
typedef struct WrinkleImageWriter WrinkleImageWriter;

typedef struct WrinkleImageHeader {
    uint32_t width;
    uint32_t height;
    uint32_t channels;  /* 1 to 4: as read() returns */
    uint32_t has_alpha; /* the last channel is alpha */
    uint32_t type;      /* PixelType: 0 u8, 1 u16, 2 half, 3 float */
} WrinkleImageHeader;

typedef struct WrinkleImageNumber {
    const char* name;
    float value;
} WrinkleImageNumber;

typedef struct WrinkleImageWrite {
    const char* format;        /* "png", "jpeg", "tiff", "openexr", "hdr" */
    const char* compression;   /* as in formats.cpp, "" if the format has no choice */
    int32_t quality;           /* jpeg only */
    WrinkleImageHeader header; /* any number of channels */
    const char* const* channel_names;
    uint32_t tile;   /* side in texels; 0: scan lines */
    uint32_t levels; /* 1: no mips */
    const WrinkleImageNumber* numbers;
    uint32_t number_count;
    uint32_t threads; /* compression threads of OpenEXR; 0: one per core */
} WrinkleImageWrite;

/* Error message of one sentence, truncated to `capacity`, always terminated. */
typedef struct WrinkleImageText {
    char* text;
    uint32_t capacity;
} WrinkleImageText;

typedef struct WrinkleImageModule {
    uint32_t size; /* size of this struct in the module */
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
    /* Opens a file for writing; returns NULL and the reason on failure. If this or a function below
     * fails, the caller removes the file. */
    WrinkleImageWriter* (*begin)(const char* path, const WrinkleImageWrite* what,
                                 WrinkleImageText why);
    /* Writes `count` rows of a mip level from row `first` on, in order for each level; interleaved,
     * of header.type. `count` is a multiple of the tile side, or of 64 for scan lines, or reaches
     * the last row. */
    int32_t (*rows)(WrinkleImageWriter* writer, uint32_t level, const void* pixels, uint32_t first,
                    uint32_t count, WrinkleImageText why);
    /* Completes the file after all rows; destroys the writer. */
    int32_t (*end)(WrinkleImageWriter* writer, WrinkleImageText why);
    void (*drop)(WrinkleImageWriter* writer); /* instead of end() */
} WrinkleImageModule;

typedef const WrinkleImageModule* (*WrinkleImageModuleEntry)(void);

#ifdef __cplusplus
}
#endif

#endif
