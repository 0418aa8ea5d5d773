// Tooltips next to the item they describe, never over it, in screen pixels. No tooltip is shown
// while a mouse button is down, so that none covers the drag. The item is given as a rectangle; for
// a row of a list pass the rectangle of the list, so that neighboring rows stay visible.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace wrinkle::editor {

struct About {
    ImVec2 low{0, 0}, high{0, 0};
    bool aside = false;  // prefers left or right of the rectangle, else below or above
};
About last_item();
About beside_window();  // the last item's row over the window's width: menus

// Usage: `if (const Tooltip tip(about); tip)`, then add widgets to the current ImGui window.
class Tooltip {
public:
    explicit Tooltip(const About& about, float wrap = 360);
    ~Tooltip();
    Tooltip(const Tooltip&) = delete;
    Tooltip& operator=(const Tooltip&) = delete;
    explicit operator bool() const { return open_; }

private:
    bool open_;
};

void show_tooltip(const About& about, std::string_view text);
// A bold title and a plain text below it.
void show_tooltip(const About& about, ImFont* bold, std::string_view title, std::string_view text);

}  // namespace wrinkle::editor
