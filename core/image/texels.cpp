#include "image/texels.h"

#include "base/srgb.h"

namespace wrinkle {
namespace {

template <class Decode>
void decode_each(Image& image, const Decode& decode) {
    const uint32_t colors = image.channels - (image.has_alpha ? 1 : 0);
    for (size_t texel = 0; texel < image.data.size(); texel += image.channels)
        for (uint32_t c = 0; c < colors; ++c)
            image.data[texel + c] = decode(image.data[texel + c]);
}

float decoded(double coded) {
    return static_cast<float>(linear_from_srgb(coded));
}

// Decodes by a table of all steps.
void decode_steps(Image& image, uint32_t last) {
    std::vector<float> table;
    for (uint32_t step = 0; step <= last; ++step)
        table.push_back(decoded(step / double(last)));
    decode_each(image, [&](float value) {
        return table[static_cast<size_t>(value * static_cast<float>(last) + 0.5F)];
    });
}

}  // namespace

void decode_srgb(Image& image) {
    switch (image.source) {
        case PixelType::u8:
            return decode_steps(image, 255);
        case PixelType::u16:
            return decode_steps(image, 65535);
        default:
            return decode_each(image, decoded);
    }
}

std::optional<MipChain> load_texels(const TexelSource& source, const ImageLimits& limits,
                                    Diagnostics& diagnostics) {
    std::optional<Image> image = load_image(source.file, limits, diagnostics);
    if (!image) return {};
    if (source.srgb) decode_srgb(*image);
    return build_mips(std::move(*image));
}

}  // namespace wrinkle
