// Thumbnails of image files as textures, loaded on the first request, at most one per frame.
// Requires the window's GL context to be current; without use_gl() there are none.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>

namespace wrinkle::editor {

// Makes an RGBA8 texture, or replaces the one in `texture`; nullptr leaves its texels undefined.
void allocate_texture(uint32_t& texture, int width, int height, const uint8_t* texels);

class Thumbnails {
public:
    static constexpr uint32_t side = 168;  // pixels; maximum width and height

    // Call before the first frame of a window; without it no file is read.
    void use_gl() { gl_ = true; }
    void forget() { textures_.clear(); }  // after their GL context was destroyed
    void begin_frame() { read_one_ = waiting_ = false; }
    // Returns the texture, bottom row first; 0 if there is none or it is not loaded yet: call
    // again.
    uint32_t of(const std::filesystem::path& file);
    // Reloads the file at the next request; until then the old texture remains.
    void forget(const std::filesystem::path& file);
    bool waiting() const { return waiting_; }  // some requests are not loaded yet

private:
    bool gl_ = false, read_one_ = false, waiting_ = false;
    std::map<std::filesystem::path, uint32_t> textures_;
    std::set<std::filesystem::path> stale_;
};

}  // namespace wrinkle::editor
