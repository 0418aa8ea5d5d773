// Draws frames and notes, below everything else.
#include <algorithm>

#include "base/text.h"
#include "editor/view/canvas/boxes.h"
#include "editor/view/canvas/painter.h"

namespace wrinkle::editor {
namespace {

constexpr size_t max_lines = 64;

void draw_outline(const Painter& p, ImVec2 low, ImVec2 high, bool selected, bool hovered) {
    const ImU32 color = selected ? theme::accent : hovered ? theme::text_dim : theme::border;
    p.list.AddRect(low, high, color, box_corner, 0, selected ? 2 : 1);
}

// The title has a minimum screen size, so that it is readable at any zoom.
void draw_title(const Painter& p, ImVec2 low, float width, std::string_view title) {
    const float size = std::max(18 * p.zoom, 12.0F);
    ImFont* font = p.state.fonts.bold(size);
    draw_text(p.list, font, size, low + ImVec2(16, 9) * p.zoom, theme::text_dim,
              fitting(font, size, title, width - 24 * p.zoom));
}

void draw_lines(const Painter& p, ImVec2 low, ImVec2 high, std::string_view text) {
    const float size = 16 * p.zoom, step = 20 * p.zoom;
    if (size < 6) return;
    ImFont* font = p.state.fonts.regular(size);
    const float room = high.x - low.x - 28 * p.zoom;
    ImVec2 at = low + ImVec2(16, 10) * p.zoom;
    size_t lines = 0;
    for (const std::string_view line : split(text, '\n')) {
        const char* next = line.data();
        const char* end = line.data() + line.size();
        do {
            const char* stop =
                std::max(font->CalcWordWrapPositionA(size / font->FontSize, next, end, room),
                         std::min(next + 1, end));
            if (at.y + step > high.y || ++lines > max_lines) return;
            draw_text(p.list, font, size, at, theme::text_dim, {next, stop});
            at.y += step;
            next = stop;
            while (next < end && *next == ' ')
                ++next;
        } while (next < end);
    }
}

}  // namespace

void draw_boxes(const Painter& p) {
    const std::vector<BoxId> boxes = all_boxes(p.state.document());
    for (size_t i = 0; i < boxes.size(); ++i) {
        const Box& box = *find_box(p.state.document(), boxes[i]);
        const Extent extent = extent_of(p.state, boxes[i], box);
        if (!p.sees(extent)) continue;
        const ImVec2 low = p.at(extent.low), high = p.at(extent.high);
        const bool note = boxes[i].note;
        const Hit& hit = p.state.hovered;
        const bool hovered = hit.kind == Hit::Kind::box && hit.part == i;
        p.list.AddRectFilled(low, high,
                             note ? theme::bar : theme::with_alpha(theme::accent, 0.045F),
                             note ? 0 : box_corner);
        const bool selected = p.view.boxes.contains(boxes[i]);
        if (!note || selected || hovered) draw_outline(p, low, high, selected, hovered);
        if (note) {
            p.list.AddRectFilled(low, {low.x + 3, high.y}, theme::control);
            draw_lines(p, low, high, box.text);
        } else {
            draw_title(p, low, high.x - low.x, box.text);
        }
    }
}

}  // namespace wrinkle::editor
