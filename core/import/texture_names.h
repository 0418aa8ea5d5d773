// Channels of a material that a texture file holds, recognised by the end of its name.
//
// A name is split into words at characters that are neither letters nor digits, between a small and
// a capital letter, before the last of several capital letters, and before digits after a letter:
// "Bricks102_1K-JPG_NormalGL" has the words bricks, 102, 1k, jpg, normal, gl. Case is ignored. The
// last words that are a key of the table (texture_names.cpp) select the role; words after them that
// state a resolution, a format, a color space, a level of detail, or an index of at most two digits
// are skipped. The longest key is taken: "ambient occlusion" before "occlusion".
//
// Covered are the names of ambientCG, Poly Haven, Quixel Megascans, FreePBR, cgbookcase,
// Textures.com, Poliigon, Substance and the packings of Unreal, Unity and glTF.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "maps/map.h"

namespace wrinkle::textures {

enum class Channel : uint8_t {
    color,
    normal,
    roughness,
    metalness,
    occlusion,
    height,
    opacity,
    emission
};
inline constexpr size_t channel_count = 8;
std::string_view name_of(Channel channel);  // "color": the standard output

enum class Component : uint8_t { rgb, red, green, blue, alpha };
std::string_view name_of(Component component);

// A channel in a component of an image, linear but for colors.
struct ChannelSource {
    Channel channel = Channel::color;
    Component component = Component::rgb;
    bool inverted = false;  // roughness = 1 - gloss
};

// Direction of the green of a normal map, as far as a name states it.
enum class NamedGreen : uint8_t { unknown, gl, dx };

struct TextureRole {
    std::string_view key;                    // "normalgl"
    std::span<const ChannelSource> sources;  // empty: known, but no channel of a material
    NamedGreen green = NamedGreen::unknown;
    // The file with the lowest rank is used for a channel: a single map before a packed one,
    // roughness before gloss, a height before a bump.
    uint8_t rank = 0;
};

struct RecognisedNames {
    // For each stem its role; nullptr if it is not recognised, or if it is the name of the set
    // itself, as of a preview: all words of its key belong to the common beginning of the others.
    std::vector<const TextureRole*> roles;
    // The common beginning of the recognised names in the spelling of the first, without resolution
    // and format: "Bricks102"; "" if they have none.
    std::string set;
};

// `stems` are file names without folder and extension.
RecognisedNames recognise(std::span<const std::string> stems);

}  // namespace wrinkle::textures
