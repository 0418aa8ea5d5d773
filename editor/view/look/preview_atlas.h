// Atlas texture of node previews of one size. Requires the window's GL context to be current;
// without use_gl() the atlas stays empty.
#pragma once

#include <cstdint>
#include <span>

namespace wrinkle::editor {

class PreviewAtlas {
public:
    void use_gl() { gl_ = true; }
    void forget() { texture_ = 0; }  // after its GL context was destroyed

    // Replaces the contents: RGBA8 previews of width x height texels each, one after the other.
    // Stores as many as the maximum texture size allows.
    void fill(std::span<const uint8_t> texels, uint32_t width, uint32_t height);

    uint32_t texture() const { return texture_; }  // 0: none
    uint32_t count() const { return count_; }
    // Texture coordinates of a preview, 0 to 1; bottom row first.
    struct Place {
        float u0 = 0, v0 = 0, u1 = 0, v1 = 0;
    };
    Place place(uint32_t index) const;

private:
    bool gl_ = false;
    uint32_t texture_ = 0, count_ = 0, rows_ = 1;
};

}  // namespace wrinkle::editor
