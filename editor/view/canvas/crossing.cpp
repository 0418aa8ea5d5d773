#include "editor/view/canvas/canvas.h"

#include <algorithm>
#include <cmath>

namespace wrinkle::editor {
namespace {

constexpr int steps = 32;

float across(ImVec2 a, ImVec2 b) {
    return a.x * b.y - a.y * b.x;
}

std::optional<ImVec2> meeting(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d) {
    const ImVec2 along = b - a, other = d - c;
    const float area = across(along, other);
    if (area == 0) return std::nullopt;
    const float t = across(c - a, other) / area, u = across(c - a, along) / area;
    if (t < 0 || t > 1 || u < 0 || u > 1) return std::nullopt;
    return a + along * t;
}

}  // namespace

Curve curve_of(const Wire& wire) {
    return wire_curve(wire.start, wire.end, 1);
}

std::optional<ImVec2> crossing(const Layout& layout, size_t wire, ImVec2 a, ImVec2 b) {
    if (!layout.wire_boxes[wire].touches(Extent::between(a, b))) return std::nullopt;
    const Curve curve = curve_of(layout.wires[wire]);
    ImVec2 last = curve.a;
    for (int i = 1; i <= steps; ++i) {
        const ImVec2 next = curve.at(static_cast<float>(i) / steps);
        if (const auto at = meeting(last, next, a, b)) return at;
        last = next;
    }
    return std::nullopt;
}

std::optional<size_t> wire_under(const Layout& layout, const Card& card) {
    const Extent box = card.extent();
    const ImVec2 middle = card.at + card.size * 0.5F;
    std::optional<size_t> found;
    float best = 0;
    for (size_t i = 0; i < layout.wires.size(); ++i) {
        const Wire& wire = layout.wires[i];
        if (wire.node == card.id || wire.from.node == card.id) continue;
        if (!layout.wire_boxes[i].touches(box)) continue;
        const Curve curve = curve_of(wire);
        for (int k = 0; k <= steps; ++k) {
            const ImVec2 at = curve.at(static_cast<float>(k) / steps);
            if (!box.touches({at, at})) continue;
            const float distance = std::hypot(at.x - middle.x, at.y - middle.y);
            if (found && distance >= best) continue;
            best = distance;
            found = i;
        }
    }
    return found;
}

}  // namespace wrinkle::editor
