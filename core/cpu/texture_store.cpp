#include "cpu/texture_store.h"

#include <algorithm>

#include "image/load.h"

namespace wrinkle {

std::shared_ptr<const MipChain> TextureStore::read(const std::string& file, Diagnostics& problems) {
    const bool is_new = texels_.try_emplace(file).second;
    if (!is_new) return find(file);
    Diagnostics wrong_limits;
    ImageLimits limits = image_limits_from_environment(wrong_limits);
    problems.append_once(wrong_limits);
    if (wrong_limits.has_errors()) return nullptr;
    limits.left_bytes = max_bytes_ - std::min(max_bytes_, bytes_);
    auto image = load_image(file, limits, problems);
    if (!image || image->empty()) return nullptr;
    bytes_ += bytes_with_mips(*image);
    auto chain = std::make_shared<const MipChain>(build_mips(std::move(*image)));
    texels_[file] = std::make_shared<const PackedMipChain>(chain);
    return chain;
}

std::shared_ptr<const MipChain> TextureStore::find(const std::string& file) const {
    const auto found = texels_.find(file);
    return found == texels_.end() || !found->second ? nullptr : found->second->chain();
}

std::vector<Texture> TextureStore::textures_of(std::span<const Resource> resources) const {
    std::vector<Texture> textures;
    for (const Resource& resource : resources) {
        const auto found = texels_.find(resource.file);
        textures.emplace_back(found == texels_.end() ? nullptr : found->second, resource.options);
    }
    return textures;
}

}  // namespace wrinkle
