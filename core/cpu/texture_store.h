// Cache of image files as textures; the texels of a file are loaded once and shared by all users,
// twice if they are sampled both decoded from sRGB and as stored.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/diagnostics.h"
#include "base/limits.h"
#include "cpu/texture.h"
#include "image/texels.h"
#include "ir/side_tables.h"

namespace wrinkle {

class TextureStore {
public:
    // Loads the texels on the first request and returns their mip chain; null on failure. An image
    // that would exceed the limit of all images together (Limit::all_images_bytes) is refused.
    // Errors are reported only on the first request.
    std::shared_ptr<const MipChain> read(const TexelSource& source, Diagnostics& problems);

    // Returns null if the texels were not requested or could not be loaded.
    std::shared_ptr<const MipChain> find(const TexelSource& source) const;

    // Returns textures by resource index; a black one for each image that is not loaded.
    std::vector<Texture> textures_of(std::span<const Resource> resources) const;

    void forget() {
        texels_.clear();
        bytes_ = 0;
    }

private:
    std::map<TexelSource, std::shared_ptr<const PackedMipChain>> texels_;
    uint64_t bytes_ = 0;  // total of all images
    uint64_t max_bytes_ = limit_of(Limit::all_images_bytes);
};

}  // namespace wrinkle
