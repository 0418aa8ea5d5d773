#include "image/png/png_codec.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/codec_support.h"
#include "image/png/session.h"

struct WrinkleImageReader {
    explicit WrinkleImageReader(const char* path) : session(path, wrinkle::png::Access::read) {}

    wrinkle::png::Session session;
    size_t row_bytes = 0;
    uint32_t height = 0;
    bool interlaced = false;
    std::vector<png_byte> image = {};  // all rows of an interlaced image, after the first read
};

struct WrinkleImageWriter {
    explicit WrinkleImageWriter(const char* path) : session(path, wrinkle::png::Access::write) {}

    wrinkle::png::Session session;
    size_t row_bytes = 0;
};

namespace wrinkle::png {
namespace {

using codec::guarded;

constexpr uint32_t rows_at_once = 64;
constexpr const char* description = "Description";  // keyword of the PNG specification

// The header after png_set_expand(). libpng itself reports it only after it has allocated rows, and
// the caller has not checked the width yet.
WrinkleImageHeader header_of(png_structp png, png_infop info) {
    const int color = png_get_color_type(png, info);
    const bool alpha =
        (color & PNG_COLOR_MASK_ALPHA) || png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    const bool u16 = png_get_bit_depth(png, info) == 16;
    WrinkleImageHeader header = {};
    header.width = png_get_image_width(png, info);
    header.height = png_get_image_height(png, info);
    header.channels = (color & PNG_COLOR_MASK_COLOR ? 3 : 1) + (alpha ? 1 : 0);
    header.has_alpha = alpha;
    header.type = static_cast<uint32_t>(u16 ? PixelType::u16 : PixelType::u8);
    return header;
}

WrinkleImageReader* open(const char* path, const char*, uint32_t, WrinkleImageHeader* header,
                         WrinkleImageText why) {
    return guarded(why, [&]() -> WrinkleImageReader* {
        auto reader = std::make_unique<WrinkleImageReader>(path);
        reader->session.call([&](png_structp png, png_infop info) {
            png_read_info(png, info);
            *header = header_of(png, info);
        });
        reader->height = header->height;
        return reader.release();
    });
}

void begin_reading(WrinkleImageReader& reader) {
    reader.session.call([&](png_structp png, png_infop info) {
        reader.interlaced = png_get_interlace_type(png, info) != PNG_INTERLACE_NONE;
        png_set_expand(png);
        if (std::endian::native == std::endian::little) png_set_swap(png);
        png_set_interlace_handling(png);
        png_read_update_info(png, info);
        reader.row_bytes = png_get_rowbytes(png, info);
    });
}

uint32_t band(const WrinkleImageReader*) {
    return rows_at_once;
}

void read_all(WrinkleImageReader& reader) {
    reader.image.resize(reader.row_bytes * reader.height);
    std::vector<png_bytep> rows;
    for (uint32_t y = 0; y < reader.height; ++y)
        rows.push_back(&reader.image[y * reader.row_bytes]);
    reader.session.call([&](png_structp png, png_infop) { png_read_image(png, rows.data()); });
}

int32_t read(WrinkleImageReader* reader, uint32_t first, uint32_t count, void* pixels,
             WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        auto* out = static_cast<png_bytep>(pixels);
        if (first == 0) begin_reading(*reader);
        if (reader->interlaced) {
            if (first == 0) read_all(*reader);
            std::copy_n(&reader->image[first * reader->row_bytes], count * reader->row_bytes, out);
            return 1;
        }
        reader->session.call([&](png_structp png, png_infop) {
            for (uint32_t i = 0; i < count; ++i)
                png_read_row(png, out + i * reader->row_bytes, nullptr);
        });
        return 1;
    });
}

void close(WrinkleImageReader* reader) {
    delete reader;
}

int32_t number(const char* path, const char*, uint32_t, const char* name, float* value) {
    char ignored[1];
    return guarded({ignored, 1}, [&]() -> int32_t {
        Session session(path, Access::read);
        png_textp texts = nullptr;
        int count = 0;
        session.call([&](png_structp png, png_infop info) {
            png_read_info(png, info);
            png_get_text(png, info, &texts, &count);
        });
        for (int i = 0; i < count; ++i)
            if (std::string_view(texts[i].key) == description)
                return codec::find_number(texts[i].text, name, *value);
        return 0;
    });
}

void declare(Session& session, const WriterOptions& options) {
    constexpr int color_types[] = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                   PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
    std::string numbers = codec::numbers_as_text(options.numbers), key = description;
    png_text text = {};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = key.data();
    text.text = numbers.data();
    session.call([&](png_structp png, png_infop info) {
        png_set_IHDR(png, info, options.width, options.height,
                     options.type == PixelType::u16 ? 16 : 8,
                     color_types[options.channels.size() - 1], PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        if (!options.numbers.empty()) png_set_text(png, info, &text, 1);
        // Nearly all repetition in filtered rows is in runs: maps of materials are 0 to 12 % larger
        // than by the defaults of libpng and zlib, in a fourth to an eighth of the time.
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_PAETH);
        png_set_compression_strategy(png, Z_RLE);
        png_write_info(png, info);
        if (std::endian::native == std::endian::little) png_set_swap(png);
    });
}

WrinkleImageWriter* begin(const char* path, const char*, const WriterOptions& options, uint32_t,
                          WrinkleImageText why) {
    return guarded(why, [&]() -> WrinkleImageWriter* {
        auto writer = std::make_unique<WrinkleImageWriter>(path);
        writer->row_bytes =
            size_t{options.width} * options.channels.size() * bytes_of(options.type);
        declare(writer->session, options);
        return writer.release();
    });
}

int32_t write_rows(WrinkleImageWriter* writer, uint32_t, const void* pixels, uint32_t,
                   uint32_t count, WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        const auto* rows = static_cast<png_const_bytep>(pixels);
        writer->session.call([&](png_structp png, png_infop) {
            for (uint32_t i = 0; i < count; ++i)
                png_write_row(png, rows + i * writer->row_bytes);
        });
        return 1;
    });
}

int32_t end(WrinkleImageWriter* writer, WrinkleImageText why) {
    const std::unique_ptr<WrinkleImageWriter> owned(writer);
    return guarded(why, [&]() -> int32_t {
        owned->session.call([](png_structp png, png_infop) { png_write_end(png, nullptr); });
        owned->session.close_file();
        return 1;
    });
}

void drop(WrinkleImageWriter* writer) {
    delete writer;
}

}  // namespace

const WrinkleImageCodec table = {sizeof(WrinkleImageCodec),
                                 WRINKLE_IMAGE_MODULE_VERSION,
                                 open,
                                 band,
                                 read,
                                 close,
                                 number,
                                 begin,
                                 write_rows,
                                 end,
                                 drop};

}  // namespace wrinkle::png
