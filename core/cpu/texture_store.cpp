#include "cpu/texture_store.h"

#include <algorithm>

namespace wrinkle {

std::shared_ptr<const MipChain> TextureStore::read(const TexelSource& source,
                                                   Diagnostics& problems) {
    const bool is_new = texels_.try_emplace(source).second;
    if (!is_new) return find(source);
    Diagnostics wrong_limits;
    ImageLimits limits = image_limits_from_environment(wrong_limits);
    problems.append_once(wrong_limits);
    if (wrong_limits.has_errors()) return nullptr;
    limits.left_bytes = max_bytes_ - std::min(max_bytes_, bytes_);
    auto loaded = load_texels(source, limits, problems);
    if (!loaded) return nullptr;
    bytes_ += bytes_with_mips(loaded->levels[0]);
    auto chain = std::make_shared<const MipChain>(std::move(*loaded));
    texels_[source] = std::make_shared<const PackedMipChain>(chain);
    return chain;
}

std::shared_ptr<const MipChain> TextureStore::find(const TexelSource& source) const {
    const auto found = texels_.find(source);
    return found == texels_.end() || !found->second ? nullptr : found->second->chain();
}

std::vector<Texture> TextureStore::textures_of(std::span<const Resource> resources) const {
    std::vector<Texture> textures;
    for (const Resource& resource : resources) {
        const auto found = texels_.find(texels_of(resource));
        textures.emplace_back(found == texels_.end() ? nullptr : found->second, resource.options);
    }
    return textures;
}

}  // namespace wrinkle
