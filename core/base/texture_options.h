// Sampling options of an image: encoding, wrap and filter, as set in a graph file. They are
// metadata of a texture; the arithmetic of an encoding (2t - 1, z from x and y) is emitted where an
// expression samples the texture. t is the stored value. The texels of srgb images are decoded when
// they are loaded, so mips and filters work on linear values.
//
//   linear      the stored value                 srgb         sRGB-encoded color, linearised
//   normal_gl   2t - 1, green = +v               normal_dx    2t - 1, green = -v
//   normal_rg   x, y in red, green; z derived    normal_ag    x in alpha * red, y in green
//   derivative  2t - 1, (dh/du, dh/dv)
//
// The order of the enumerators is part of the plugin ABI: append only.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "base/text.h"

namespace wrinkle {

enum class Encoding : uint8_t {
    linear,
    srgb,
    normal_gl,
    normal_dx,
    normal_rg,
    normal_ag,
    derivative
};
enum class Wrap : uint8_t { repeat, clamp, mirror };
enum class Filter : uint8_t { linear, nearest };

// Decoder of srgb images: the sampler, or for hosts without sRGB textures the shader, which decodes
// the filtered stored value.
enum class SrgbDecoder : uint8_t { sampler, shader };

struct TextureOptions {
    Encoding encoding = Encoding::linear;
    Wrap wrap = Wrap::repeat;
    Filter filter = Filter::linear;
    SrgbDecoder srgb = SrgbDecoder::sampler;

    // Returns true if the texels are decoded from sRGB when they are loaded.
    bool decodes_texels() const {
        return encoding == Encoding::srgb && srgb == SrgbDecoder::sampler;
    }

    friend bool operator==(const TextureOptions&, const TextureOptions&) = default;
};

// Names as spelled in graph files, in the order of the enumerators.
inline constexpr std::array<std::string_view, 7> encoding_names = {
    "linear", "srgb", "normal_gl", "normal_dx", "normal_rg", "normal_ag", "derivative"};
inline constexpr std::array<std::string_view, 3> wrap_names = {"repeat", "clamp", "mirror"};
inline constexpr std::array<std::string_view, 2> filter_names = {"linear", "nearest"};

constexpr std::string_view name_of(Encoding encoding) {
    return encoding_names[static_cast<size_t>(encoding)];
}
constexpr std::string_view name_of(Wrap wrap) {
    return wrap_names[static_cast<size_t>(wrap)];
}
constexpr std::string_view name_of(Filter filter) {
    return filter_names[static_cast<size_t>(filter)];
}

// Return std::nullopt for an unknown name.
inline std::optional<Encoding> encoding_named(std::string_view name) {
    return enumerator_named<Encoding>(encoding_names, name);
}
inline std::optional<Wrap> wrap_named(std::string_view name) {
    return enumerator_named<Wrap>(wrap_names, name);
}
inline std::optional<Filter> filter_named(std::string_view name) {
    return enumerator_named<Filter>(filter_names, name);
}

}  // namespace wrinkle
