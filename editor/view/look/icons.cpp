
#include <cmath>
#include <cstdlib>
#include <numbers>

#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

// Strokes in pixels relative to the center: M starts a path at a point, L adds a line to a point, Z
// closes the path. O is a separate arc: center, radius, and two angles in degrees, clockwise from
// the right.
struct Icon {
    std::string_view name;
    const char* strokes;
};
constexpr Icon icons[] = {
    {"undo", "M -3 -6 L -6 -3 L -3 0 M -6 -3 L 2 -3 O 2 1 4 -90 90 M 2 5 L -2 5"},
    {"redo", "M 3 -6 L 6 -3 L 3 0 M 6 -3 L -2 -3 O -2 1 4 90 270 M -2 5 L 2 5"},
    {"add-node", "M -5 0 L 5 0 M 0 -5 L 0 5"},
    {"align-left",
     "M -6 -6 L -6 6 M -3 -4.5 L 5 -4.5 L 5 -1.5 L -3 -1.5 Z M -3 1.5 L 1 1.5 L 1 4.5 "
     "L -3 4.5 Z"},
    {"tidy",
     "M -6 -6 L -1 -6 L -1 -2 L -6 -2 Z M 2 2 L 6 2 L 6 6 L 2 6 Z M -3.5 -2 L -3.5 4 L 2 4"},
    {"mute", "O 0 0 6 0 360 M -4.2 4.2 L 4.2 -4.2"},
    {"preview-node", "O 0 5 8 -141 -39 O 0 -5 8 39 141 O 0 0 2.2 0 360"},
    {"find", "O -1 -1 4.5 0 360 M 2.4 2.4 L 6 6"},
    {"commands", "O -1 -1 4.5 0 360 M 2.4 2.4 L 6 6"},
    {"export-glsl", "M 0 2 L 0 -6 M -3 -3 L 0 -6 L 3 -3 M -6 1 L -6 6 L 6 6 L 6 1"},
    {"bake", "M -6 -5 L 6 -5 L 6 5 L -6 5 Z M -6 4 L -2 0 L 2 4 M 1 3 L 3 1 L 6 4"},
    {"save",
     "M -5.5 -5.5 L 3.5 -5.5 L 5.5 -3.5 L 5.5 5.5 L -5.5 5.5 Z M -3 -5.5 L -3 -2 L 2 -2 "
     "L 2 -5.5 M -3 5.5 L -3 1.5 L 3 1.5 L 3 5.5"},
    {"delete", "M -5 -4 L 5 -4 M -2 -4 L -2 -6 L 2 -6 L 2 -4 M -4 -4 L -3 6 L 3 6 L 4 -4"},
    {"fit", "M -6 -3 L -6 -6 L -3 -6 M 3 -6 L 6 -6 L 6 -3 M 6 3 L 6 6 L 3 6 M -3 6 L -6 6 L -6 3"},
    {"zoom-in", "M -4 0 L 4 0 M 0 -4 L 0 4"},
    {"zoom-out", "M -4 0 L 4 0"},
    {"camera", "M -6 -3 L -3 -3 L -2 -5 L 2 -5 L 3 -3 L 6 -3 L 6 5 L -6 5 Z O 0 1 2.4 0 360"},
    {"maximise", "M -6 -5 L 6 -5 L 6 6 L -6 6 Z M -6 -2.5 L 6 -2.5"},
    {"restore", "M -6 -2 L 3 -2 L 3 6 L -6 6 Z M -3 -2 L -3 -5 L 6 -5 L 6 3 L 3 3"},
    {"more", "O -5 0 0.7 0 360 O 0 0 0.7 0 360 O 5 0 0.7 0 360"},
    {"copy", "M -2 -2 L 6 -2 L 6 6 L -2 6 Z M -4 3 L -6 3 L -6 -6 L 3 -6 L 3 -4"},
    {"down", "M -3.5 -2 L 0 2 L 3.5 -2"},
    {"play", "M -4 -6 L 6 0 L -4 6 Z"},
    {"pause", "M -3 -5 L -3 5 M 3 -5 L 3 5"},
    {"check", "M -5 0 L -2 4 L 5 -4"},
    {"into", "M -2 -4 L 2 0 L -2 4"},
    {"cross", "M -4 -4 L 4 4 M -4 4 L 4 -4"},
};

const char* strokes_of(std::string_view name) {
    for (const Icon& icon : icons)
        if (icon.name == name) return icon.strokes;
    return "";
}

}  // namespace

void draw_icon(ImDrawList& list, std::string_view name, ImVec2 center, ImU32 color) {
    const char* at = strokes_of(name);
    const auto number = [&] {
        char* rest = nullptr;
        const float value = std::strtof(at, &rest);
        at = rest;
        return value;
    };
    const auto point = [&] {
        const float x = number(), y = number();
        return center + ImVec2(x, y);
    };
    const auto end = [&](bool closed) {
        list.PathStroke(color, closed ? ImDrawFlags_Closed : 0, 1.5F);
    };
    while (*at) {
        const char what = *at++;
        if (what == 'M' || what == 'O') end(false);
        if (what == 'M' || what == 'L') list.PathLineTo(point());
        if (what == 'Z') end(true);
        if (what != 'O') continue;
        const ImVec2 middle = point();
        const float radius = number(), degree = std::numbers::pi_v<float> / 180;
        const float from = number() * degree, to = number() * degree;
        list.PathArcTo(middle, radius, from, to, 20);
        end(false);
    }
    end(false);
}

}  // namespace wrinkle::editor
