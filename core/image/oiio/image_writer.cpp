#include "image/oiio/image_writer.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/codec_support.h"
#include "image/oiio/exr_file.h"
#include "image/oiio/output_file.h"
#include "image/oiio/settings.h"

// Writes through `exr` or `output`; only one of them is set.
struct WrinkleImageWriter {
    explicit WrinkleImageWriter(const char* path) : file(path) {}

    wrinkle::oiio::OutputFile file;  // outlives the two below, which write on destruction
    std::optional<wrinkle::oiio::ExrFile> exr;
    OIIO::ImageSpec spec;
    std::unique_ptr<OIIO::ImageOutput> output;
};

namespace wrinkle::oiio {

using codec::Failure;
using codec::guarded;

namespace {

using OIIO::ImageOutput;
using OIIO::ImageSpec;

constexpr const char* description = "ImageDescription";

ImageSpec spec_to_write(std::string_view format, const WriterOptions& options) {
    ImageSpec spec(static_cast<int>(options.width), static_cast<int>(options.height),
                   static_cast<int>(options.channels.size()),
                   types.at(static_cast<size_t>(options.type)));
    spec.alpha_channel = options.has_alpha ? spec.nchannels - 1 : -1;
    spec.channelnames = options.channels;
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == "tiff") spec.attribute("DateTime", "");  // otherwise the current time
    if (format == "jpeg") {
        spec.attribute("jpeg:subsampling", "4:4:4");
        spec.attribute("compression", "jpeg:" + std::to_string(options.quality));
    }
    if (!options.compression.empty()) spec.attribute("compression", options.compression);
    spec.tile_width = spec.tile_height = static_cast<int>(options.tile);
    spec.tile_depth = options.tile > 0 ? 1 : 0;
    if (!options.numbers.empty())
        spec.attribute(description, codec::numbers_as_text(options.numbers));
    return spec;
}

// Throws the system's error if there is one, otherwise the library's.
void fail(const WrinkleImageWriter& writer, const std::string& otherwise) {
    const std::string reason = writer.file.failure();
    throw Failure(reason.empty() ? otherwise : reason);
}

// Runs `work`, which calls OpenEXR's C library; throws the system's error if a write failed.
template <typename Work>
void with_reason(const WrinkleImageWriter& writer, Work work) {
    try {
        work();
    } catch (const Failure& failure) {
        fail(writer, failure.what());
    }
    if (!writer.file.failure().empty()) fail(writer, "");
}

void open_output(WrinkleImageWriter& writer, const char* path, const char* format,
                 const WriterOptions& options) {
    writer.output = ImageOutput::create(format);
    if (!writer.output) throw Failure(OIIO::geterror());
    writer.spec = spec_to_write(format, options);
    if (!writer.output->set_ioproxy(&writer.file) || !writer.output->open(path, writer.spec))
        fail(writer, writer.output->geterror());
}

// Texels outside of the image are 0; OpenImageIO would write uninitialised memory.
bool write_whole_tiles(const WrinkleImageWriter& writer, const char* rows, int begin, int end) {
    const ImageSpec& spec = writer.spec;
    const size_t texel = spec.pixel_bytes(), stride = texel * static_cast<size_t>(spec.width);
    std::vector<char> tile(spec.tile_bytes());
    for (int y = begin; y < end; y += spec.tile_height)
        for (int x = 0; x < spec.width; x += spec.tile_width) {
            const int height = std::min(spec.tile_height, end - y);
            const int width = std::min(spec.tile_width, spec.width - x);
            std::ranges::fill(tile, char{0});
            for (int row = 0; row < height; ++row)
                std::memcpy(&tile[row * texel * spec.tile_width],
                            rows + (y - begin + row) * stride + x * texel, width * texel);
            if (!writer.output->write_tile(x, y, 0, spec.format, tile.data())) return false;
        }
    return true;
}

}  // namespace

WrinkleImageWriter* begin_image(const char* path, const char* format, const WriterOptions& options,
                                uint32_t levels, WrinkleImageText why) {
    return guarded(why, [&]() -> WrinkleImageWriter* {
        set_up_once();
        auto writer = std::make_unique<WrinkleImageWriter>(path);
        if (!writer->file.failure().empty()) fail(*writer, "");
        if (std::string_view(format) == "openexr")
            with_reason(*writer,
                        [&] { writer->exr.emplace(writer->file, path, options, levels > 1); });
        else
            open_output(*writer, path, format, options);
        return writer.release();
    });
}

int32_t write_rows(WrinkleImageWriter* writer, uint32_t level, const void* pixels, uint32_t first,
                   uint32_t count, WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        if (writer->exr) {
            const auto* texels = static_cast<const std::byte*>(pixels);
            with_reason(*writer, [&] { writer->exr->write(level, texels, first, count); });
            return 1;
        }
        const ImageSpec& spec = writer->spec;
        const int begin = static_cast<int>(first), end = static_cast<int>(first + count);
        const bool written =
            spec.tile_width == 0
                ? writer->output->write_scanlines(begin, end, 0, spec.format, pixels)
                : write_whole_tiles(*writer, static_cast<const char*>(pixels), begin, end);
        if (!written || !writer->file.failure().empty()) fail(*writer, writer->output->geterror());
        return 1;
    });
}

int32_t end_image(WrinkleImageWriter* writer, WrinkleImageText why) {
    const std::unique_ptr<WrinkleImageWriter> owned(writer);
    return guarded(why, [&]() -> int32_t {
        if (owned->exr) with_reason(*owned, [&] { owned->exr->close(); });
        const bool closed = owned->exr || owned->output->close();
        owned->file.close();
        if (!closed) fail(*owned, owned->output->geterror());
        if (!owned->file.failure().empty()) fail(*owned, "");
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
    return codec::find_number(spec.get_string_attribute(description), name, value);
}

}  // namespace wrinkle::oiio
