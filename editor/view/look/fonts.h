// Fonts of the editor, each baked at several sizes, so that text is only scaled down slightly at
// any zoom of the canvas and any interface scale. Sizes are ImGui's: line heights in logical pixels
// (as all coordinates); `scale` device pixels are one logical pixel.
//
// Uses Inter and JetBrains Mono if installed, else DejaVu, else ImGui's default font.
#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

namespace wrinkle::editor {

class Fonts {
public:
    // Replaces the font atlas of the current ImGui context; call between frames.
    void load(float scale = 1);

    float scale() const { return scale_; }
    uint64_t generation() const { return generation_; }  // differs after every load()

    // Interface text: 14, 16, 18 and 24 are baked exactly.
    ImFont* regular(float size) const { return at_least(regular_, size * scale_).font; }
    ImFont* bold(float size) const { return at_least(bold_, size * scale_).font; }
    ImFont* code() const { return code_; }
    // Font for text magnified to `size`. `drawn` receives the glyph size to draw: at most the baked
    // size, and at least four fifths of it. Text up to 20 device pixels is rounded to integer
    // sizes.
    ImFont* magnified(bool bold, float size, float& drawn) const;

private:
    struct Baked {
        float pixels;  // nominal size; a wide face is baked smaller
        ImFont* font;
    };
    static const Baked& at_least(const std::vector<Baked>& fonts, float pixels);
    std::vector<Baked> regular_, bold_;  // ascending
    ImFont* code_ = nullptr;
    float scale_ = 1;
    uint64_t generation_ = 0;
};

}  // namespace wrinkle::editor
