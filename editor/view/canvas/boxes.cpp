#include "editor/view/canvas/boxes.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/painter.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

constexpr float grip = 6;  // screen pixels on either side of an edge

// The edges within `reach`, as bits: left 1, right 2, top 4, bottom 8.
uint8_t edges_at(ImVec2 at, const Extent& box, float reach) {
    const bool in_x = at.x >= box.low.x - reach && at.x <= box.high.x + reach;
    const bool in_y = at.y >= box.low.y - reach && at.y <= box.high.y + reach;
    if (!in_x || !in_y) return 0;
    unsigned edges = 0;
    if (std::fabs(at.x - box.low.x) <= reach) edges |= 1;
    if (std::fabs(at.x - box.high.x) <= reach) edges |= 2;
    if (std::fabs(at.y - box.low.y) <= reach) edges |= 4;
    if (std::fabs(at.y - box.high.y) <= reach) edges |= 8;
    return static_cast<uint8_t>(edges);
}

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

Extent extent_of(const Box& box) {
    const ImVec2 low(static_cast<float>(box.rect.x), static_cast<float>(box.rect.y));
    return {low,
            low + ImVec2(static_cast<float>(box.rect.width), static_cast<float>(box.rect.height))};
}

Extent extent_of(const CanvasState& canvas, const BoxId& id, const Box& box) {
    const Gesture& g = canvas.gesture;
    const bool carried = g.kind == Gesture::Kind::move && g.carried_boxes.contains(id);
    const ImVec2 by = carried ? g.offset : ImVec2(0, 0);
    const Extent stored = extent_of(box);
    return {stored.low + by, stored.high + by};
}

std::optional<Hit> pick_box(const State& state, ImVec2 mouse) {
    const ImVec2 at = to_canvas(state.view, mouse);
    const float zoom = state.view.zoom;
    const std::vector<BoxId> boxes = all_boxes(state.document());
    for (size_t i = boxes.size(); i-- > 0;) {
        const Box& box = *find_box(state.document(), boxes[i]);
        const Extent extent = extent_of(state, boxes[i], box);
        Hit hit{Hit::Kind::box, Hit::no_card, i, edges_at(at, extent, grip / zoom)};
        if (hit.edges != 0) return hit;
        Extent handle = extent;
        if (!boxes[i].note)
            handle.high.y =
                std::min(extent.high.y, extent.low.y + std::max(title_height, 18 / zoom));
        if (handle.contains(at)) return hit;
    }
    return std::nullopt;
}

void name_boxes(State& state) {
    for (const BoxId& id : all_boxes(state.document())) {
        const Extent extent = extent_of(state, id, *find_box(state.document(), id));
        const ImVec2 low = to_screen(state.view, extent.low);
        ImVec2 high = to_screen(state.view, extent.high);
        if (!id.note) high.y = std::min(high.y, low.y + title_height * state.view.zoom);
        state.targets.add((id.note ? "note:" : "frame:") + id.id, {low.x, low.y, high.x, high.y});
    }
}

void add_contents(const State& state, const BoxId& frame, std::set<std::string>& cards,
                  std::set<BoxId>& boxes) {
    const Box* box = find_box(state.document(), frame);
    if (!box) return;
    boxes.insert(frame);
    if (frame.note) return;
    const Extent outer = extent_of(state, frame, *box);
    for (const Card& card : state.layout.cards)
        if (outer.contains(card.extent())) cards.insert(card.id);
    for (const BoxId& other : all_boxes(state.document()))
        if (outer.contains(extent_of(state, other, *find_box(state.document(), other))))
            boxes.insert(other);
}

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
