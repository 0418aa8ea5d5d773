// Image files as textures, each read once and shared by all that sample it.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "cpu/texture.h"
#include "ir/module.h"

namespace wrinkle {

class TextureStore {
public:
    // Reads a file that was not asked for before; one that all together are too large with is
    // refused (Limit::all_images_bytes). Why one cannot be read is said that time alone.
    std::shared_ptr<const MipChain> read(const std::string& file, Diagnostics& problems);

    // Null for one that was not, or could not be, read.
    std::shared_ptr<const MipChain> find(const std::string& file) const;

    // Textures by resource index; a black one for an image that is not there.
    std::vector<Texture> textures_of(std::span<const Resource> resources) const;

    void forget() {
        texels_.clear();
        bytes_ = 0;
    }

private:
    std::map<std::string, std::shared_ptr<const Texels>> texels_;
    uint64_t bytes_ = 0;  // of all of them
    uint64_t most_bytes_ = limit_of(Limit::all_images_bytes);
};

}  // namespace wrinkle
