// The faces of the editor, each baked at several sizes, so that text is only ever scaled down a
// little, at any zoom of the canvas and any scale of the interface. Sizes are ImGui's: line
// heights. A size is in logical pixels (as all coordinates are); `scale` device pixels make one.
//
// Inter and JetBrains Mono where they are installed, else DejaVu, else ImGui's own.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

namespace wrinkle::editor {

class Fonts {
public:
    // Into the atlas of the current ImGui context, in place of what is there; between frames.
    void load(float scale = 1);

    float scale() const { return scale_; }
    uint64_t generation() const { return generation_; }  // differs after every load()

    // For the interface: 14, 16, 18 and 24 are there exactly.
    ImFont* regular(float size) const { return at_least(regular_, size * scale_).font; }
    ImFont* bold(float size) const { return at_least(bold_, size * scale_).font; }
    ImFont* code() const { return code_; }
    // For text magnified to `size`: the size to draw its glyphs at is in `drawn`, never above that
    // of the font, and less by a fifth at most. Small text keeps to whole pixels.
    ImFont* magnified(bool bold, float size, float& drawn) const;

private:
    struct Baked {
        float pixels;  // of the size it stands for; a wide face is baked smaller
        ImFont* font;
    };
    static const Baked& at_least(const std::vector<Baked>& fonts, float pixels);
    std::vector<Baked> regular_, bold_;  // ascending
    ImFont* code_ = nullptr;
    float scale_ = 1;
    uint64_t generation_ = 0;
};

}  // namespace wrinkle::editor
