#include "image/oiio/image_writer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/oiio/guard.h"
#include "image/oiio/output_file.h"

struct WrinkleImageWriter {
    explicit WrinkleImageWriter(const char* where) : path(where), file(where) {}

    std::string path;
    wrinkle::oiio::OutputFile file;  // outlives the output, which writes when it goes
    OIIO::ImageSpec spec;
    std::unique_ptr<OIIO::ImageOutput> output;
    bool whole_tiles = false;  // the format has no others
};

namespace wrinkle::oiio {

namespace {

using OIIO::ImageOutput;
using OIIO::ImageSpec;

constexpr const char* description = "ImageDescription";

// Numbers as text, for formats without attributes of any name.
std::string numbers_as_text(const WrinkleImageWrite& what) {
    std::string text;
    for (uint32_t i = 0; i < what.number_count; ++i) {
        char number[64];
        std::snprintf(number, sizeof number, "=%.9g", static_cast<double>(what.numbers[i].value));
        text += (text.empty() ? "" : " ") + std::string(what.numbers[i].name) + number;
    }
    return text;
}

void name_channels(ImageSpec& spec, const WrinkleImageWrite& what) {
    spec.alpha_channel = what.header.has_alpha ? spec.nchannels - 1 : -1;
    for (size_t c = 0; c < spec.channelnames.size(); ++c)
        spec.channelnames[c] = what.channel_names[c];
}

void add_numbers(ImageSpec& spec, const WrinkleImageWrite& what) {
    if (std::string_view(what.format) != "openexr") {
        const std::string text = numbers_as_text(what);
        if (!text.empty()) spec.attribute(description, text);
        return;
    }
    for (uint32_t i = 0; i < what.number_count; ++i)
        spec.attribute(what.numbers[i].name, what.numbers[i].value);
}

ImageSpec spec_to_write(const WrinkleImageWrite& what) {
    const WrinkleImageHeader& header = what.header;
    ImageSpec spec(static_cast<int>(header.width), static_cast<int>(header.height),
                   static_cast<int>(header.channels), types.at(header.type));
    name_channels(spec, what);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const std::string_view format = what.format;
    if (format == "png") spec.attribute("png:filter", 0xF8);  // all row filters: smaller by far
    if (format == "openexr" || format == "tiff")
        spec.attribute("DateTime", "");  // else it would be now
    if (format == "jpeg") {
        spec.attribute("jpeg:subsampling", "4:4:4");
        spec.attribute("compression", "jpeg:" + std::to_string(what.quality));
    }
    if (*what.compression) spec.attribute("compression", what.compression);
    spec.tile_width = spec.tile_height = static_cast<int>(what.tile);
    spec.tile_depth = what.tile > 0 ? 1 : 0;
    if (what.levels > 1) spec.attribute("textureformat", "Plain Texture");
    add_numbers(spec, what);
    return spec;
}

void fail(const WrinkleImageWriter& writer) {
    const std::string reason = writer.file.failure();
    throw Failure(reason.empty() ? writer.output->geterror() : reason);
}

void open_image(WrinkleImageWriter& writer, ImageOutput::OpenMode mode) {
    if (!writer.output->open(writer.path, writer.spec, mode)) fail(writer);
}

// What stands outside of the picture is 0, where OpenImageIO would leave what its memory held.
bool write_whole_tiles(const WrinkleImageWriter& writer, const char* rows, int begin, int end) {
    const ImageSpec& spec = writer.spec;
    const size_t texel = spec.pixel_bytes(), stride = texel * static_cast<size_t>(spec.width);
    std::vector<char> tile(spec.tile_bytes());
    for (int y = begin; y < end; y += spec.tile_height)
        for (int x = 0; x < spec.width; x += spec.tile_width) {
            const int height = std::min(spec.tile_height, end - y);
            const int width = std::min(spec.tile_width, spec.width - x);
            std::fill(tile.begin(), tile.end(), char{0});
            for (int row = 0; row < height; ++row)
                std::memcpy(&tile[row * texel * spec.tile_width],
                            rows + (y - begin + row) * stride + x * texel, width * texel);
            if (!writer.output->write_tile(x, y, 0, spec.format, tile.data())) return false;
        }
    return true;
}

}  // namespace

WrinkleImageWriter* begin_image(const char* path, const WrinkleImageWrite* what,
                                WrinkleImageText why) {
    return guarded(why, [&]() -> WrinkleImageWriter* {
        set_up_once();
        need_exr_threads(what->threads);
        auto writer = std::make_unique<WrinkleImageWriter>(path);
        writer->output = ImageOutput::create(what->format);
        if (!writer->output) throw Failure(OIIO::geterror());
        writer->whole_tiles = std::string_view(what->format) != "openexr";
        writer->spec = spec_to_write(*what);
        if (!writer->file.failure().empty() || !writer->output->set_ioproxy(&writer->file))
            fail(*writer);
        open_image(*writer, ImageOutput::Create);
        return writer.release();
    });
}

int32_t write_rows(WrinkleImageWriter* writer, const void* pixels, uint32_t first, uint32_t count,
                   WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        const ImageSpec& spec = writer->spec;
        ImageOutput& output = *writer->output;
        const int begin = static_cast<int>(first), end = static_cast<int>(first + count);
        bool written = false;
        if (spec.tile_width == 0)
            written = output.write_scanlines(begin, end, 0, spec.format, pixels);
        else if (writer->whole_tiles)
            written = write_whole_tiles(*writer, static_cast<const char*>(pixels), begin, end);
        else
            written = output.write_tiles(0, spec.width, begin, end, 0, 1, spec.format, pixels);
        if (!written || !writer->file.failure().empty()) fail(*writer);
        return 1;
    });
}

int32_t begin_level(WrinkleImageWriter* writer, uint32_t width, uint32_t height,
                    WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        ImageSpec& spec = writer->spec;
        spec.width = spec.full_width = static_cast<int>(width);
        spec.height = spec.full_height = static_cast<int>(height);
        open_image(*writer, ImageOutput::AppendMIPLevel);
        return 1;
    });
}

int32_t end_image(WrinkleImageWriter* writer, WrinkleImageText why) {
    const std::unique_ptr<WrinkleImageWriter> owned(writer);
    return guarded(why, [&]() -> int32_t {
        const bool closed = owned->output->close();
        owned->file.close();
        if (!closed || !owned->file.failure().empty()) fail(*owned);
        return 1;
    });
}

void drop_image(WrinkleImageWriter* writer) {
    char ignored[1];
    guarded({ignored, 1}, [&]() -> int32_t {
        delete writer;
        return 1;
    });
}

bool find_number(const ImageSpec& spec, const char* name, float& value) {
    if (const OIIO::ParamValue* attribute = spec.find_attribute(name, OIIO::TypeFloat)) {
        value = attribute->get_float();
        return true;
    }
    const std::string text = " " + std::string(spec.get_string_attribute(description));
    const std::string key = " " + std::string(name) + "=";
    const size_t place = text.find(key);
    if (place == text.npos) return false;
    char* end = nullptr;
    value = std::strtof(text.c_str() + place + key.size(), &end);
    return end != text.c_str() + place + key.size();
}

}  // namespace wrinkle::oiio
