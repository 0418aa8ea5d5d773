// Copies the images that a shader text reads to an export, in formats that hosts upload without
// loss.
//
//   8 bits          PNG of 8 bits, without color profile; sRGB or linear as in Reflection
//   16 bits, float  OpenEXR of 32-bit floats, linear: sRGB values are decoded
//
// Rows are those of the file: a viewer shows both upright.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "emit/reflection.h"

namespace wrinkle {

// Names of the files of an export's images, of letters, digits and "_": hosts read them in paths,
// URLs and quoted strings. Names that differ only in case, or are taken, get numbers.
class TextureNames {
public:
    // `from` is the image's path, `extension` ".png": "textures/brick.png".
    std::string take(const std::string& from, std::string_view extension);

private:
    std::set<std::string> taken_;  // in lower case
};

struct ExportedTexture {
    std::string sampler;    // SamplerInfo::name
    std::string file;       // below `folder`: "textures/brick.png"; one file may serve several
    bool is_float = false;  // .exr
    bool srgb = false;      // the host decodes it
    TextureOptions options;
};

// In the order of Reflection::samplers. Returns an empty list and
// appends an error if an image cannot be read or written.
std::vector<ExportedTexture> copy_textures(const Reflection& reflection,
                                           const std::filesystem::path& folder,
                                           Diagnostics& diagnostics);

}  // namespace wrinkle
