// OpenImageIO behind the table of image_module.h.

#include "image/oiio/image_module.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "image/oiio/quiet.h"

struct WrinkleImageReader {
    std::unique_ptr<OIIO::ImageInput> input;
    OIIO::TypeDesc type;
    int channels = 0;
};

namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

constexpr std::array<TypeDesc::BASETYPE, 4> types = {TypeDesc::UINT8, TypeDesc::UINT16,
                                                     TypeDesc::HALF, TypeDesc::FLOAT};

struct Failure : std::runtime_error {
    using runtime_error::runtime_error;
};

// One line: OpenImageIO's messages may be several.
std::string sentence(std::string text) {
    while (!text.empty() && (text.back() == '\n' || text.back() == ' '))
        text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text.empty() ? "it ends early or holds impossible values" : text;
}

void tell(WrinkleImageText why, const std::string& text) {
    if (why.capacity == 0) return;
    const size_t count = std::min<size_t>(text.size(), why.capacity - 1);
    std::memcpy(why.text, text.data(), count);
    why.text[count] = 0;
}

// Runs `work` so that neither an exception nor a library's printing leaves the module.
template <typename Work>
auto guarded(WrinkleImageText why, Work work) -> decltype(work()) {
    const wrinkle::Quiet quiet;
    try {
        return work();
    } catch (const std::exception& error) {
        tell(why, sentence(error.what()));
    } catch (...) {
        tell(why, "an unknown failure in OpenImageIO");
    }
    return {};
}

// The caller has its own limits and its own threads.
void set_up_once() {
    static std::once_flag once;
    std::call_once(once, [] {
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
        OIIO::attribute("tiff:half", 1);
        OIIO::attribute("limits:imagesize_MB", 0);
    });
}

TypeDesc::BASETYPE readable_type(const ImageSpec& spec) {
    const auto type = static_cast<TypeDesc::BASETYPE>(spec.format.basetype);
    const bool known = std::find(types.begin(), types.end(), type) != types.end();
    return known ? type : TypeDesc::FLOAT;
}

// UNKNOWN is "as stored", which spares OpenImageIO a 64 MiB buffer per call.
TypeDesc type_to_ask_for(const ImageSpec& spec) {
    const TypeDesc type = readable_type(spec);
    return type == spec.format && spec.channelformats.empty() ? TypeDesc::UNKNOWN : type;
}

// More than four channels are usable when the first are R, G, B and perhaps A.
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
}

WrinkleImageHeader header_of(const ImageSpec& spec, int channels) {
    WrinkleImageHeader header = {};
    header.width = static_cast<uint32_t>(std::max(spec.width, 0));
    header.height = static_cast<uint32_t>(std::max(spec.height, 0));
    header.channels = static_cast<uint32_t>(channels);
    header.has_alpha = channels == 4 || (spec.alpha_channel == 1 && channels == 2);
    const auto place = std::find(types.begin(), types.end(), readable_type(spec));
    header.type = static_cast<uint32_t>(place - types.begin());
    return header;
}

WrinkleImageReader* open_image(const char* path, const char* format, WrinkleImageHeader* header,
                               WrinkleImageText why) {
    return guarded(why, [&]() -> WrinkleImageReader* {
        set_up_once();
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

int32_t read_image(WrinkleImageReader* reader, void* pixels, WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        ImageInput& input = *reader->input;
        const bool read = input.read_image(0, 0, 0, reader->channels, reader->type, pixels);
        if (!read || input.has_error()) throw Failure(input.geterror());
        return 1;
    });
}

void close_image(WrinkleImageReader* reader) {
    const std::unique_ptr<WrinkleImageReader> owned(reader);
    char ignored[1];
    guarded({ignored, 1}, [&]() -> int32_t { return owned->input->close(); });
}

void name_channels(ImageSpec& spec, const WrinkleImageHeader& header) {
    spec.alpha_channel = header.has_alpha ? spec.nchannels - 1 : -1;
    if (spec.nchannels != 2) return;
    spec.channelnames = {header.has_alpha ? "Y" : "R", header.has_alpha ? "A" : "G"};
}

ImageSpec spec_to_write(const WrinkleImageWrite& what) {
    const WrinkleImageHeader& header = what.header;
    ImageSpec spec(static_cast<int>(header.width), static_cast<int>(header.height),
                   static_cast<int>(header.channels), types.at(header.type));
    name_channels(spec, header);
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
    return spec;
}

int32_t write_image(const char* path, const WrinkleImageWrite* what, WrinkleImageText why) {
    return guarded(why, [&]() -> int32_t {
        set_up_once();
        const auto output = ImageOutput::create(what->format);
        if (!output) throw Failure(OIIO::geterror());
        const ImageSpec spec = spec_to_write(*what);
        const bool written =
            output->open(path, spec) && output->write_image(spec.format, what->pixels);
        if (!written || !output->close()) throw Failure(output->geterror());
        return 1;
    });
}

constexpr WrinkleImageModule table = {sizeof(WrinkleImageModule),
                                      WRINKLE_IMAGE_MODULE_VERSION,
                                      open_image,
                                      read_image,
                                      close_image,
                                      write_image};

}  // namespace

extern "C" __attribute__((visibility("default"))) const WrinkleImageModule* wrinkle_image_module() {
    return &table;
}
