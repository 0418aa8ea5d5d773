// Pans the view while the user drags near the border of the canvas.
#include <algorithm>

#include "editor/view/canvas/gestures/gestures.h"
#include "editor/view/look/draw.h"

namespace wrinkle::editor {
namespace {

constexpr float margin = 20, fastest = 900;  // screen pixels; screen pixels per second

float push(float at, float low, float high) {
    const float before = low + margin - at, after = at - (high - margin);
    return std::clamp(before, 0.0F, 2 * margin) - std::clamp(after, 0.0F, 2 * margin);
}

}  // namespace

void pan_at_edges(CanvasState& canvas) {
    Gesture& g = canvas.gesture;
    const ImGuiIO& io = ImGui::GetIO();
    g.panning = false;
    if (!g.moved || g.kind == Gesture::Kind::pan || g.kind == Gesture::Kind::value) return;
    if (!ImGui::IsMousePosValid()) return;
    const View& view = canvas.view;
    const ImVec2 end = view.corner + view.extent;
    const ImVec2 by = ImVec2(push(io.MousePos.x, view.corner.x, end.x),
                             push(io.MousePos.y, view.corner.y, end.y)) *
                      (fastest * io.DeltaTime / (2 * margin));
    if (by.x == 0 && by.y == 0) return;
    g.panning = true;
    g.start = g.start + by;
    canvas.view.pan = canvas.view.pan + by;
}

}  // namespace wrinkle::editor
