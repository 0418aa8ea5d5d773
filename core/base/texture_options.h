// How the numbers of an image file are to be read: a graph file's words for a texture, as small
// enums that every folder shares. They are metadata of a texture; the arithmetic they mean (2t - 1,
// the sRGB curve, a missing z) is written out where an expression samples the texture.
//
//   linear      the stored value                 srgb         sRGB-coded colour, made linear
//   normal_gl   2t - 1, green = +v               normal_dx    2t - 1, green = -v
//   normal_rg   x, y in red, green; z follows    normal_ag    x in alpha, y in green; z follows
//   derivative  2t - 1, (dh/du, dh/dv)
//
// The order of the enumerators is part of the plugin ABI: append only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

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

struct TextureOptions {
    Encoding encoding = Encoding::linear;
    Wrap wrap = Wrap::repeat;
    Filter filter = Filter::linear;

    friend bool operator==(const TextureOptions&, const TextureOptions&) = default;
};

// The names as a graph file spells them, in the order of the enumerators.
std::span<const std::string_view> encoding_names();
std::span<const std::string_view> wrap_names();
std::span<const std::string_view> filter_names();

std::string_view name_of(Encoding encoding);
std::string_view name_of(Wrap wrap);
std::string_view name_of(Filter filter);

// Nothing for a word that is no name.
std::optional<Encoding> encoding_named(std::string_view name);
std::optional<Wrap> wrap_named(std::string_view name);
std::optional<Filter> filter_named(std::string_view name);

}  // namespace wrinkle
