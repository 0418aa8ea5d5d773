#include "cpu/texture_store.h"

#include "image/load.h"

namespace wrinkle {

std::shared_ptr<const MipChain> TextureStore::read(const std::string& file, Diagnostics& problems) {
    const auto [place, is_new] = chains_.try_emplace(file);
    if (!is_new) return place->second;
    auto image = load_image(file, problems);
    if (image && !image->empty())
        place->second = std::make_shared<const MipChain>(build_mips(std::move(*image)));
    return place->second;
}

std::shared_ptr<const MipChain> TextureStore::find(const std::string& file) const {
    const auto found = chains_.find(file);
    return found == chains_.end() ? nullptr : found->second;
}

std::vector<Texture> TextureStore::textures_of(std::span<const Resource> resources) const {
    std::vector<Texture> textures;
    for (const Resource& resource : resources)
        textures.emplace_back(find(resource.file), resource.options);
    return textures;
}

}  // namespace wrinkle
