// Implements the table of codec.h with OpenImageIO.

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "image/codec.h"
#include "image/codec_support.h"
#include "image/oiio/exr_header.h"
#include "image/oiio/image_writer.h"
#include "image/oiio/settings.h"

struct WrinkleImageReader {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::TypeDesc type;
    int channels = 0;
};

namespace wrinkle::oiio {

using codec::Failure;
using codec::guarded;

namespace {

using OIIO::ImageInput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

constexpr uint32_t scan_lines_at_once = 256;  // complete chunks of OpenEXR, few calls

TypeDesc::BASETYPE readable_type(const ImageSpec& spec) {
    const auto type = static_cast<TypeDesc::BASETYPE>(spec.format.basetype);
    const bool known = std::ranges::find(types, type) != types.end();
    return known ? type : TypeDesc::FLOAT;
}

// UNKNOWN means "as stored", which avoids a 64 MiB buffer of OpenImageIO per call.
TypeDesc type_to_ask_for(const ImageSpec& spec) {
    const TypeDesc type = readable_type(spec);
    return type == spec.format && spec.channelformats.empty() ? TypeDesc::UNKNOWN : type;
}

// Returns the number of channels to read. More than four are usable if the first are R, G, B and
// perhaps A.
int usable_channels(const ImageSpec& spec) {
    if (spec.nchannels <= 4) return spec.nchannels;
    const std::vector<std::string>& names = spec.channelnames;
    if (names.size() < 4 || names[0] != "R" || names[1] != "G" || names[2] != "B")
        throw Failure("it has " + std::to_string(spec.nchannels) +
                      " channels that do not begin with R, G, B; one to four are readable");
    return names[3] == "A" ? 4 : 3;
}

void refuse_unreadable(const ImageSpec& spec, const std::string& format) {
    if (spec.deep) throw Failure("deep images are not readable");
    if (spec.depth > 1) throw Failure("volume images are not readable");
    if (spec.nchannels < 1) throw Failure("it has no channels");
    const bool cropped = spec.x != spec.full_x || spec.y != spec.full_y ||
                         spec.width != spec.full_width || spec.height != spec.full_height;
    if (format == "openexr" && cropped)
        throw Failure("its data window differs from its display window");
    // OpenImageIO 2.4 writes past the end of such a strip when it inverts the values.
    if (spec.get_int_attribute("tiff:PhotometricInterpretation", 1) == 0 && spec.nchannels > 1)
        throw Failure("white is zero in it, which is readable of one channel alone");
}

WrinkleImageHeader header_of(const ImageSpec& spec, int channels) {
    WrinkleImageHeader header = {};
    header.width = static_cast<uint32_t>(std::max(spec.width, 0));
    header.height = static_cast<uint32_t>(std::max(spec.height, 0));
    header.channels = static_cast<uint32_t>(channels);
    header.has_alpha = channels == 4 || (spec.alpha_channel == 1 && channels == 2);
    const auto found = std::ranges::find(types, readable_type(spec));
    header.type = static_cast<uint32_t>(found - types.begin());
    return header;
}

// Throws Failure and stores the size in `header` if the image is larger than `max_side`.
void refuse_oversized_exr(const char* path, uint32_t max_side, WrinkleImageHeader& header) {
    const ExrSize size = size_of_exr(path);
    if (size.width <= max_side && size.height <= max_side) return;
    header.width = static_cast<uint32_t>(std::clamp<int64_t>(size.width, 1, UINT32_MAX));
    header.height = static_cast<uint32_t>(std::clamp<int64_t>(size.height, 1, UINT32_MAX));
    header.channels = 1;
    throw Failure("it is larger than the limit");
}

WrinkleImageReader* open_image(const char* path, const char* format, uint32_t max_side,
                               WrinkleImageHeader* header, WrinkleImageText why) {
    return guarded(why, [&]() -> WrinkleImageReader* {
        set_up_once();
        if (std::string_view(format) == "openexr") refuse_oversized_exr(path, max_side, *header);
        auto reader = std::make_unique<WrinkleImageReader>();
        reader->input = ImageInput::create(format);
        if (!reader->input) throw Failure(OIIO::geterror());
        ImageSpec config, spec;
        config.attribute("oiio:UnassociatedAlpha", 1);
        if (!reader->input->open(path, spec, config)) throw Failure(reader->input->geterror());
        refuse_unreadable(spec, format);
        reader->channels = usable_channels(spec);
        reader->type = type_to_ask_for(spec);
        *header = header_of(spec, reader->channels);
        return reader.release();
    });
}

uint32_t band_of_image(const WrinkleImageReader* reader) {
    const int tile = reader->input->spec().tile_height;
    return tile > 0 ? static_cast<uint32_t>(tile) : scan_lines_at_once;
}

int32_t read_rows(WrinkleImageReader* reader, uint32_t first, uint32_t count, void* pixels,
                  WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        ImageInput& input = *reader->input;
        const ImageSpec spec = input.spec();
        const int begin = spec.y + static_cast<int>(first), end = begin + static_cast<int>(count);
        const bool read =
            spec.tile_height > 0
                ? input.read_tiles(0, 0, spec.x, spec.x + spec.width, begin, end, spec.z,
                                   spec.z + 1, 0, reader->channels, reader->type, pixels)
                : input.read_scanlines(0, 0, begin, end, spec.z, 0, reader->channels, reader->type,
                                       pixels);
        if (!read || input.has_error()) throw Failure(input.geterror());
        return 1;
    });
}

void close_image(WrinkleImageReader* reader) {
    const std::unique_ptr<WrinkleImageReader> owned(reader);
    char ignored[1];
    guarded({ignored, 1}, [&]() -> int32_t { return owned->input->close(); });
}

int32_t read_number(const char* path, const char* format, uint32_t max_side, const char* name,
                    float* value) {
    char ignored[1];
    return guarded({ignored, 1}, [&]() -> int32_t {
        set_up_once();
        WrinkleImageHeader header = {};
        if (std::string_view(format) == "openexr") refuse_oversized_exr(path, max_side, header);
        const auto input = ImageInput::create(format);
        ImageSpec spec;
        return input && input->open(path, spec) && find_number(spec, name, *value);
    });
}

constexpr WrinkleImageCodec table = {sizeof(WrinkleImageCodec),
                                     WRINKLE_IMAGE_MODULE_VERSION,
                                     open_image,
                                     band_of_image,
                                     read_rows,
                                     close_image,
                                     read_number,
                                     begin_image,
                                     write_rows,
                                     end_image,
                                     drop_image};

}  // namespace

}  // namespace wrinkle::oiio

extern "C" __attribute__((visibility("default"))) const WrinkleImageCodec* wrinkle_image_module() {
    return &wrinkle::oiio::table;
}
