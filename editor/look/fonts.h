// The faces of the editor, each baked at several sizes, so that text on the zoomed canvas is only
// ever scaled down a little. Sizes are ImGui's: line heights in pixels.
//
// Inter and JetBrains Mono where they are installed, else DejaVu, else ImGui's own.
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

namespace wrinkle::editor {

class Fonts {
public:
    // Into the atlas of the current ImGui context; before its first frame.
    void load();

    ImFont* regular(float size) const { return nearest(regular_, size); }
    ImFont* bold(float size) const { return nearest(bold_, size); }
    ImFont* code() const { return code_; }

private:
    static ImFont* nearest(const std::vector<ImFont*>& fonts, float size);
    std::vector<ImFont*> regular_, bold_;
    ImFont* code_ = nullptr;
};

}  // namespace wrinkle::editor
