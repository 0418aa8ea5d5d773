// Pan and zoom of the canvas.
#include <algorithm>
#include <cmath>

#include "editor/canvas/layout.h"
#include "editor/look/draw.h"

namespace wrinkle::editor {

ImVec2 to_screen(const View& view, ImVec2 at) {
    return view.corner + view.pan + at * view.zoom;
}

ImVec2 to_canvas(const View& view, ImVec2 at) {
    return (at - view.corner - view.pan) * (1 / view.zoom);
}

ImVec2 pointed_at(const View& view) {
    const ImVec2 mouse = ImGui::GetIO().MousePos, end = view.corner + view.extent;
    const bool over =
        mouse.x >= view.corner.x && mouse.y >= view.corner.y && mouse.x < end.x && mouse.y < end.y;
    return over ? mouse : (view.corner + end) * 0.5F;
}

void fit(View& view, const Layout& layout, bool selection_only) {
    ImVec2 low = layout.low, high = layout.high;
    bool first = true;
    for (const Card& card : layout.cards) {
        if (!selection_only || !view.selected.contains(card.id)) continue;
        const ImVec2 end = card.at + card.size;
        low = first ? card.at : ImVec2(std::min(low.x, card.at.x), std::min(low.y, card.at.y));
        high = first ? end : ImVec2(std::max(high.x, end.x), std::max(high.y, end.y));
        first = false;
    }
    const ImVec2 size = high - low;
    const ImVec2 room = view.extent - ImVec2(64, 88);
    const float scale = std::min(room.x / std::max(size.x, 1.0F), room.y / std::max(size.y, 1.0F));
    view.zoom = std::clamp(scale, 0.05F, 1.0F);
    // Fields are worth a little of the margin.
    if (view.zoom > detail_zoom * 0.95F) view.zoom = std::max(view.zoom, detail_zoom);
    view.pan = view.extent * 0.5F - (low + high) * (0.5F * view.zoom);
    view.pan = {std::round(view.pan.x), std::round(view.pan.y)};
}

void zoom_at(View& view, ImVec2 screen, float factor) {
    const ImVec2 fixed = to_canvas(view, screen);
    view.zoom = std::clamp(view.zoom * factor, 0.05F, 4.0F);
    view.pan = screen - view.corner - fixed * view.zoom;
}

}  // namespace wrinkle::editor
