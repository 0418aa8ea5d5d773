// Options of a bake besides the map names: defaults, limits and help texts. `wrinkle bake` and the
// editor's bake dialog share them.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace wrinkle {

inline constexpr std::array<uint32_t, 4> bake_sample_counts = {1, 4, 16, 64};
inline constexpr uint32_t max_baked_side = 65536;  // texels
inline constexpr uint32_t max_bake_tile = 4096;    // side of tiles in files
// File formats by extension; image/formats.h defines the types that each can store.
inline constexpr std::array bake_formats = {"png", "tif", "exr", "hdr"};

struct BakeTuning {
    double scale = 1;
    uint32_t samples = 4;          // one of bake_sample_counts
    uint32_t dilate = 16;          // texels, up to max_dilation
    std::string compression = {};  // "": default of the format
    uint32_t tile = 0;             // side of tiles in files; a multiple of 16, 0: rows

    bool operator==(const BakeTuning&) const = default;
};

namespace bake_words {

inline constexpr const char* map =
    "Maps, separated by commas: outputs of the graph, and derivative and slopes of its "
    "normal; default: normal";
inline constexpr const char* pack =
    "A map of others' channels: \"orm: r=occlusion g=roughness b=metalness\"";
inline constexpr const char* space =
    "Space of normals; world is object space, as meshes are not moved";
inline constexpr const char* gl = "Green of normals is +v; the default";
inline constexpr const char* dx = "Green of normals is -v";
inline constexpr const char* scale = "Heights, slopes and derivatives are divided by this";
inline constexpr const char* udim = "Every square of uv has a map of its own: OUT.1001.png";
inline constexpr const char* samples = "Points per texel that an island's border crosses";
inline constexpr const char* dilate = "Texels by which islands grow over what is empty";
inline constexpr const char* type = "Type of the stored numbers; default: u8, half in OpenEXR";
inline constexpr const char* compression = "OpenEXR: none rle zip zips piz; TIFF: none lzw zip";
inline constexpr const char* tile = "Side of the tiles in OpenEXR and TIFF; 0: rows";

}  // namespace bake_words

}  // namespace wrinkle
