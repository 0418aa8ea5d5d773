// Pan and zoom of the canvas.
#include <algorithm>
#include <cmath>

#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

// Horizontal and vertical margins; the breadcrumb and the zoom overlay the outer 44 pixels.
const ImVec2 wide_margin(32, 60), min_margin(24, 48);

// Also of graphs that are larger. ImGui 1.86 divides by zero in circles with radii below 1e-6.
constexpr float least_zoom = 1e-4F;

float fitting_zoom(const View& view, const Extent& shown, ImVec2 margin) {
    const ImVec2 size = shown.high - shown.low;
    const ImVec2 room(std::max(view.extent.x - 2 * margin.x, 1.0F),
                      std::max(view.extent.y - 2 * margin.y, 1.0F));
    const float zoom = std::min(room.x / std::max(size.x, 1.0F), room.y / std::max(size.y, 1.0F));
    return std::max(zoom, least_zoom);
}

}  // namespace

ImVec2 to_screen(const View& view, ImVec2 at) {
    return view.corner + view.pan + at * view.zoom;
}

ImVec2 to_canvas(const View& view, ImVec2 at) {
    return (at - view.corner - view.pan) * (1 / view.zoom);
}

ImVec2 pointed_at(const View& view) {
    const ImVec2 mouse = ImGui::GetIO().MousePos, end = view.corner + view.extent;
    return Extent{view.corner, end}.contains(mouse) ? mouse : (view.corner + end) * 0.5F;
}

void fit(View& view, const Layout& layout, bool selection_only) {
    Extent shown;
    for (const Card& card : layout.cards)
        if (selection_only && view.selected.contains(card.id)) shown.add(card.extent());
    if (shown.empty()) shown = layout.bounds;
    view.zoom = std::min(fitting_zoom(view, shown, wide_margin), 1.0F);
    // Reduces the margin if that makes fields visible.
    if (view.zoom < detail_zoom && fitting_zoom(view, shown, min_margin) >= detail_zoom)
        view.zoom = detail_zoom;
    view.pan = view.extent * 0.5F - (shown.low + shown.high) * (0.5F * view.zoom);
    view.pan = {std::round(view.pan.x), std::round(view.pan.y)};
}

void zoom_at(View& view, const Layout& layout, ImVec2 screen, float factor) {
    const ImVec2 fixed = to_canvas(view, screen);
    const float least = std::min(0.05F, fitting_zoom(view, layout.bounds, wide_margin));
    view.zoom = std::clamp(view.zoom * factor, least, 4.0F);
    view.pan = screen - view.corner - fixed * view.zoom;
}

Extent minimap_area(const View& view) {
    const ImVec2 size(168, 112), margin(16, 16);
    if (view.extent.x < 700 || view.extent.y < 280) return {};
    const ImVec2 high = view.corner + view.extent - margin;
    return {high - size, high};
}

bool is_in_sight(const View& view, const Card& card) {
    const ImVec2 low = to_screen(view, card.at);
    return Extent{view.corner, view.corner + view.extent}.contains(
        Extent{low, low + card.size * view.zoom});
}

void bring_in_sight(View& view, const Card& card) {
    const ImVec2 low = to_screen(view, card.at) - view.corner;
    const ImVec2 high = low + card.size * view.zoom;
    // Shows the upper left corner of a card that is larger than the canvas.
    const auto shift = [](float from, float to, float margin, float room) {
        if (to > room - margin) from -= to - (room - margin), to = 0;
        return std::max(from, margin);
    };
    view.pan = view.pan + ImVec2(shift(low.x, high.x, min_margin.x, view.extent.x) - low.x,
                                 shift(low.y, high.y, min_margin.y, view.extent.y) - low.y);
    const ImVec2 at = to_screen(view, card.at);
    const Extent map = minimap_area(view), shown{at, at + card.size * view.zoom};
    const float over = shown.high.x - (map.low.x - min_margin.x / 2);
    if (map.touches(shown) && at.x - over >= view.corner.x + min_margin.x) view.pan.x -= over;
}

}  // namespace wrinkle::editor
