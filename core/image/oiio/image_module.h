/* The border between core/image and the module that holds OpenImageIO, and OpenEXR's own library
 * for the files of that kind that are written.
 *
 * The module exports one symbol, wrinkle_image_module, which returns a table of functions. Only
 * plain data crosses: rows run top to bottom as in files, values keep the file's own type, texts
 * are written into the caller's buffer, and no exception leaves. Everything may be called from
 * several threads; one reader or writer belongs to one thread at a time.
 */
#ifndef WRINKLE_IMAGE_MODULE_H
#define WRINKLE_IMAGE_MODULE_H

#include <stdint.h>

#define WRINKLE_IMAGE_MODULE_VERSION 4u
#define WRINKLE_IMAGE_MODULE_SYMBOL "wrinkle_image_module"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct WrinkleImageReader WrinkleImageReader; /* the module's own */
typedef struct WrinkleImageWriter WrinkleImageWriter;

typedef struct WrinkleImageHeader {
    uint32_t width;
    uint32_t height;
    uint32_t channels;  /* 1 to 4: those that read gives */
    uint32_t has_alpha; /* the last of them is an alpha */
    uint32_t type;      /* PixelType: 0 u8, 1 u16, 2 half, 3 float */
} WrinkleImageHeader;

typedef struct WrinkleImageNumber {
    const char* name;
    float value;
} WrinkleImageNumber;

typedef struct WrinkleImageWrite {
    const char* format;        /* "png", "jpeg", "tiff", "openexr", "hdr" */
    const char* compression;   /* as writable.cpp has it, "" where there is none to choose */
    int32_t quality;           /* jpeg */
    WrinkleImageHeader header; /* any number of channels */
    const char* const* channel_names;
    uint32_t tile;   /* its side; 0: scan lines */
    uint32_t levels; /* 1: no mips */
    const WrinkleImageNumber* numbers;
    uint32_t number_count;
    uint32_t threads; /* that compress OpenEXR; 0 is one for each core */
} WrinkleImageWrite;

/* One sentence of what went wrong, cut at `capacity`, always terminated. */
typedef struct WrinkleImageText {
    char* text;
    uint32_t capacity;
} WrinkleImageText;

typedef struct WrinkleImageModule {
    uint32_t size; /* of this struct as the module knows it */
    uint32_t version;
    /* Reads the header of a file of the format named; NULL with the reason. An OpenEXR file wider
     * or higher than `max_side` is refused with its size in `header`. */
    WrinkleImageReader* (*open)(const char* path, const char* format, uint32_t max_side,
                                WrinkleImageHeader* header, WrinkleImageText why);
    /* How many rows `read` likes to take at once: a row of tiles, or some scan lines. */
    uint32_t (*band)(const WrinkleImageReader* reader);
    /* Decodes width * count * channels values of header.type; 0 with the reason. `first` is a
     * multiple of band(), `count` too unless it reaches the last row; bands come in order. */
    int32_t (*read)(WrinkleImageReader* reader, uint32_t first, uint32_t count, void* pixels,
                    WrinkleImageText why);
    void (*close)(WrinkleImageReader* reader);
    /* A number that the writer below has put beside the pixels of a file; 0 when there is none. */
    int32_t (*number)(const char* path, const char* format, uint32_t max_side, const char* name,
                      float* value);
    /* Opens a file for writing; NULL with the reason. Whoever gets a reason from this or from what
     * follows removes the file. */
    WrinkleImageWriter* (*begin)(const char* path, const WrinkleImageWrite* what,
                                 WrinkleImageText why);
    /* `count` rows of a mip level from row `first` on, each level's in order; interleaved, of
     * header.type. `count` is a multiple of the tiles' side, or of 64, or reaches the last row. */
    int32_t (*rows)(WrinkleImageWriter* writer, uint32_t level, const void* pixels, uint32_t first,
                    uint32_t count, WrinkleImageText why);
    /* Writes what is left when all rows are there; the writer is gone afterwards. */
    int32_t (*end)(WrinkleImageWriter* writer, WrinkleImageText why);
    void (*drop)(WrinkleImageWriter* writer); /* in place of end() */
} WrinkleImageModule;

typedef const WrinkleImageModule* (*WrinkleImageModuleEntry)(void);

#ifdef __cplusplus
}
#endif

#endif
