// A set of textures of one material: which file holds which channel, and facts that the names do
// not state, read from the pixels.
//
// Two steps: find_textures() assigns files to channels by their names and opens no image;
// examine_textures() opens the files that are used. Both report every problem with the file and a
// remedy. Warnings: images that are left out, a green that neither the name nor the slopes state,
// slopes that contradict the name, a channel that the image lacks. Errors: nothing recognised, two
// files of equal rank for one channel, an image that cannot be read.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/texture_options.h"
#include "image/load.h"
#include "import/texture_names.h"

namespace wrinkle::textures {

// Files of a folder that are examined at most; more are an error.
inline constexpr size_t max_folder_files = 1000;

struct Texture {
    std::filesystem::path file;  // as found: folder / name
    ChannelSource source;
    const TextureRole* role = nullptr;
    ImageInfo info;  // after examine_textures()
};

struct TextureSet {
    std::string name;  // "Bricks102"; the folder's name if the file names share no beginning
    std::array<std::optional<Texture>, channel_count> channels;  // by Channel
    Encoding normal_encoding = Encoding::normal_gl;
    // Height of white over black in texels of the height map, fitted to the slopes of the normal
    // map; std::nullopt without both maps of one size, or if their slopes do not agree.
    std::optional<double> relief;

    const Texture* find(Channel channel) const {
        const auto& found = channels[static_cast<size_t>(channel)];
        return found ? &*found : nullptr;
    }
};

// `inputs` is one folder, of which the images are taken (not those of its sub-folders), or images.
// In a folder, files without the extension of an image are ignored. Links are followed; anything
// but a regular file is left out. Returns std::nullopt after an error.
std::optional<TextureSet> find_textures(const std::vector<std::filesystem::path>& inputs,
                                        Diagnostics& diagnostics);

struct ExamineOptions {
    std::optional<maps::Green> green = {};  // overrides names and pixels
    std::function<bool()> stopped = {};     // as maps::examine()
};

// Reads the headers of all images, the pixels of the normal map (direction of green, by
// maps::examine()), those of a color map with alpha if no other file holds the opacity (an alpha
// below 1 anywhere makes it the opacity), and those of the height map if there is a normal map of
// its size (`relief`). Returns false after an error, or if `stopped` returned true.
bool examine_textures(TextureSet& set, const ExamineOptions& options, Diagnostics& diagnostics);

}  // namespace wrinkle::textures
