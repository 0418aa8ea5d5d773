// Small pictures of one size in one texture. Wants the window's GL context current; without one
// there are none.
#pragma once

#include <cstdint>
#include <span>

namespace wrinkle::editor {

class PictureAtlas {
public:
    void use_gl() { gl_ = true; }
    void forget() { texture_ = 0; }  // its context is gone

    // In place of those there were: RGBA, one after the other. As many as fit into a texture.
    void fill(std::span<const uint8_t> texels, uint32_t width, uint32_t height);

    uint32_t texture() const { return texture_; }  // 0: none
    uint32_t count() const { return count_; }
    // Where a picture stands, as fractions of the texture; bottom row first.
    struct Place {
        float u0 = 0, v0 = 0, u1 = 0, v1 = 0;
    };
    Place place(uint32_t index) const;

private:
    bool gl_ = false;
    uint32_t texture_ = 0, count_ = 0, rows_ = 1;
};

}  // namespace wrinkle::editor
