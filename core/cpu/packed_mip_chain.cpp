#include "cpu/packed_mip_chain.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "cpu/wrap.h"

namespace wrinkle {
namespace {

constexpr uint32_t not_packable = ~0u;

// Returns three times each byte in ten bits each; `not_packable` if a value is not byte / 255 or
// the texel is not opaque.
uint32_t packed_texel(const float* values, const Image& image) {
    const auto texel = expand_texel(values, image.channels, image.has_alpha);
    if (texel[3] != 1) return not_packable;
    uint32_t packed = 0;
    for (size_t c = 0; c < 3; ++c) {
        if (!(texel[c] >= 0 && texel[c] <= 1)) return not_packable;
        const auto byte = static_cast<uint32_t>(texel[c] * 255 + 0.5F);
        if (static_cast<float>(byte) / 255 != texel[c] || std::signbit(texel[c]))
            return not_packable;
        packed |= 3 * byte << packed_shift[c];
    }
    return packed;
}

int64_t wrapped_index(int64_t i, uint32_t size, Wrap wrap) {
    return wrap == Wrap::repeat ? texel_index<Wrap::repeat>(i, int64_t{size})
                                : texel_index<Wrap::clamp>(i, int64_t{size});
}

// Returns an empty vector if the image does not consist of opaque bytes.
std::vector<uint32_t> packed_level(const Image& image, Wrap wrap) {
    if (image.source != PixelType::u8) return {};
    const size_t row = image.width + size_t{2};
    std::vector<uint32_t> packed(row * (image.height + size_t{2}) + packed_padding);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x) {
            const uint32_t texel = packed_texel(image.texel(x, y), image);
            if (texel == not_packable) return {};
            packed[(y + size_t{1}) * row + x + 1] = texel;
        }
    const auto left = static_cast<size_t>(wrapped_index(-1, image.width, wrap));
    const auto right = static_cast<size_t>(wrapped_index(image.width, image.width, wrap));
    for (size_t y = 1; y <= image.height; ++y) {
        packed[y * row] = packed[y * row + left + 1];
        packed[y * row + row - 1] = packed[y * row + right + 1];
    }
    const auto copy_row = [&](int64_t from, size_t to) {
        const auto start = packed.begin() + (from + 1) * static_cast<int64_t>(row);
        std::copy_n(start, row, packed.begin() + static_cast<int64_t>(to * row));
    };
    copy_row(wrapped_index(-1, image.height, wrap), 0);
    copy_row(wrapped_index(image.height, image.height, wrap), image.height + size_t{1});
    return packed;
}

}  // namespace

void PackedMipChain::make(Wrap wrap, Form& form) const {
    const std::vector<Image>& images = chain_->levels;
    constexpr size_t max_floats = size_t{1} << 30;
    if (images[0].data.size() > max_floats) return;
    form.packed = packed_level(images[0], wrap);
    for (const Image& image : images) {
        TexelLevel level;
        level.width = static_cast<int32_t>(image.width);
        level.height = static_cast<int32_t>(image.height);
        const bool packed = form.levels.empty() && !form.packed.empty();
        level.packed = packed ? form.packed.data() : nullptr;
        level.floats = packed ? nullptr : image.data.data();
        level.stored = packed ? 3 : static_cast<int32_t>(image.channels);
        level.has_alpha = !packed && image.has_alpha;
        form.levels.push_back(level);
    }
}

std::span<const TexelLevel> PackedMipChain::levels(Wrap wrap) const {
    Form& form = forms_[wrap == Wrap::repeat ? 0 : 1];
    std::call_once(form.once, [&] { make(wrap, form); });
    return form.levels;
}

}  // namespace wrinkle
