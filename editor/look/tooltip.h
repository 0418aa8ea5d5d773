// Boxes of words beside what they are about, in screen pixels: never over it. There is none while a
// button of the mouse is down, so that none covers what is dragged. The part of a window that a
// tooltip is about is given as a rectangle; a row of a list gives the list, as its neighbours would
// be covered otherwise.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace wrinkle::editor {

struct About {
    ImVec2 low{0, 0}, high{0, 0};
    bool aside = false;  // left or right of it where there is room, else below or above
};
About last_item();
About beside_window();  // the current one: of a menu's items

// If `Tooltip tip(...)`: fill the ImGui window that is current then.
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
// A bold line and a plain one.
void show_tooltip(const About& about, ImFont* bold, std::string_view title, std::string_view text);

}  // namespace wrinkle::editor
