// Small pictures of files as textures, read when they are first asked for, one a frame. Wants the
// window's GL context current; without one there are no pictures.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>

namespace wrinkle::editor {

class Thumbnails {
public:
    static constexpr uint32_t side = 168;  // pixels; greater pictures are made smaller

    // Before the first frame of a window; without it nothing is ever read.
    void use_gl() { gl_ = true; }
    void forget() { textures_.clear(); }  // their context is gone
    void begin_frame() { read_one_ = waiting_ = false; }
    // The texture, bottom row first; 0 when there is none, or not yet: ask again.
    uint32_t of(const std::filesystem::path& file);
    // Read again when it is next asked for; until then the former picture stays.
    void forget(const std::filesystem::path& file);
    bool waiting() const { return waiting_; }  // some were asked for and not read yet

private:
    bool gl_ = false, read_one_ = false, waiting_ = false;
    std::map<std::filesystem::path, uint32_t> textures_;
    std::set<std::filesystem::path> stale_;
};

}  // namespace wrinkle::editor
