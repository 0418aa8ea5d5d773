#include "editor/view/look/draw.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "editor/view/look/theme.h"

namespace wrinkle::editor {
namespace {

// An outline that is not convex is two convex halves, split between its first and middle corner.
void draw_outline(ImDrawList& list, std::span<const ImVec2> corners, ImVec2 center, float unit,
                  ImU32 color, bool filled, ImU32 ground, bool convex) {
    ImVec2 points[8];
    const int count = static_cast<int>(corners.size()), half = convex ? count - 1 : count / 2;
    for (int i = 0; i <= count; ++i)
        points[i] = center + corners[static_cast<size_t>(i % count)] * unit;
    list.AddConvexPolyFilled(points, half + 1, filled ? color : ground);
    if (!convex) list.AddConvexPolyFilled(points + half, count - half + 1, filled ? color : ground);
    if (!filled) list.AddPolyline(points, count, color, ImDrawFlags_Closed, 1.8F);
}

const ImVec2 triangle[] = {{-0.75F, -0.95F}, {1, 0}, {-0.75F, 0.95F}};
const ImVec2 square[] = {{-0.8F, -0.8F}, {0.8F, -0.8F}, {0.8F, 0.8F}, {-0.8F, 0.8F}};
const ImVec2 slant[] = {{-1.05F, 0.8F}, {-0.2F, -0.8F}, {1.05F, -0.8F}, {0.2F, 0.8F}};
const ImVec2 arrow[] = {{-0.3F, 0}, {-0.95F, -1}, {1.05F, 0}, {-0.95F, 1}};
const ImVec2 diamond[] = {{0, -1.1F}, {1, 0}, {0, 1.1F}, {-1, 0}};
const ImVec2 dome[] = {{-1.05F, 0.65F}, {-0.9F, 0}, {-0.45F, -0.5F}, {0, -0.65F},
                       {0.45F, -0.5F},  {0.9F, 0},  {1.05F, 0.65F}};

const ImVec2 hourglass[] = {{-0.28F, 0}, {-0.9F, -1}, {0.9F, -1},
                            {0.28F, 0},  {0.9F, 1},   {-0.9F, 1}};

const ImVec2 hexagon[] = {{-1.05F, 0}, {-0.52F, -0.9F}, {0.52F, -0.9F},
                          {1.05F, 0},  {0.52F, 0.9F},   {-0.52F, 0.9F}};

struct PinShape {
    PortType type;
    std::span<const ImVec2> corners;
    bool convex = true;
};
const PinShape pin_shapes[] = {
    {PortType::vec3_, triangle},          {PortType::vec4_, square},
    {PortType::color_, hourglass, false}, {PortType::height_, dome},
    {PortType::derivative_, slant},       {PortType::gradient_, arrow, false},
    {PortType::normal_, diamond},         {PortType::image_, square},
    {PortType::material_, hexagon},
};

// Glyphs are sharp at their baked size, so a baked size near `size` is used as it is.
float baked_size(ImFont* font, float size) {
    const float baked = font->FontSize * font->Scale;
    return baked > 0.84F * size && baked < 1.13F * size ? baked : size;
}

}  // namespace

void draw_pin(ImDrawList& list, PortType type, ImVec2 c, float unit, ImU32 color, bool filled,
              ImU32 ground) {
    const ImU32 inner = filled ? color : ground;
    if (type == PortType::float_) {
        list.AddCircleFilled(c, unit * 0.86F, inner);
        if (!filled) list.AddCircle(c, unit * 0.86F, color, 0, 1.8F);
    } else if (type == PortType::vec2_) {
        const ImVec2 half(unit * 0.62F, unit);
        list.AddRectFilled(c - half, c + half, inner, half.x);
        if (!filled) list.AddRect(c - half, c + half, color, half.x, 0, 1.8F);
    } else {
        const PinShape& shape = *std::ranges::find(pin_shapes, type, &PinShape::type);
        draw_outline(list, shape.corners, c, unit, color, filled, ground, shape.convex);
    }
    if (type == PortType::image_) list.AddCircleFilled(c, unit * 0.33F, filled ? ground : color);
}

void draw_text(ImDrawList& list, ImFont* font, float size, ImVec2 at, ImU32 color,
               std::string_view text, bool right_aligned) {
    if (text.empty()) return;
    if (right_aligned) at.x -= text_width(font, size, text);
    at.x = std::floor(at.x);
    at.y = std::floor(at.y);
    list.AddText(font, baked_size(font, size), at, color, text.data(), text.data() + text.size());
}

float text_width(ImFont* font, float size, std::string_view text) {
    if (text.empty()) return 0;  // data() may be null
    return font
        ->CalcTextSizeA(baked_size(font, size), FLT_MAX, 0, text.data(), text.data() + text.size())
        .x;
}

std::string fitting(ImFont* font, float size, std::string_view text, float width) {
    if (text_width(font, size, text) <= width) return std::string(text);
    const float room = width - text_width(font, size, "...");
    const char* rest = nullptr;
    font->CalcTextSizeA(baked_size(font, size), std::max(room, 1.0F), 0, text.data(),
                        text.data() + text.size(), &rest);
    return std::string(text.data(), rest) + "...";
}

std::vector<std::string> wrapped(ImFont* font, float size, std::string_view text, float width,
                                 size_t most) {
    std::vector<std::string> lines;
    while (!text.empty() && lines.size() + 1 < most && text_width(font, size, text) > width) {
        size_t end = 0;
        for (size_t at = text.find(' '); at != text.npos; at = text.find(' ', at + 1))
            if (text_width(font, size, text.substr(0, at)) <= width) end = at;
        if (end == 0) break;  // not even a word fits
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end + 1);
    }
    if (!text.empty()) lines.push_back(fitting(font, size, text, width));
    return lines;
}

ImVec2 Curve::at(float t) const {
    const float s = 1 - t;
    return a * (s * s * s) + b * (3 * s * s * t) + c * (3 * s * t * t) + d * (t * t * t);
}

Curve wire_curve(ImVec2 start, ImVec2 end, float zoom) {
    const float bend = std::max(40 * zoom, std::fabs(end.x - start.x) / 2);
    return {start, start + ImVec2(bend, 0), end - ImVec2(bend, 0), end};
}

void draw_dashed(ImDrawList& list, const Curve& curve, ImU32 color, float thickness, float dash,
                 float gap) {
    constexpr int steps = 96;
    ImVec2 last = curve.a;
    float along = 0;
    for (int i = 1; i <= steps; ++i) {
        const ImVec2 next = curve.at(static_cast<float>(i) / steps);
        if (std::fmod(along, dash + gap) < dash) list.AddLine(last, next, color, thickness);
        along += std::hypot(next.x - last.x, next.y - last.y);
        last = next;
    }
}

namespace {

// Black on the light colors of the dark theme, white in the light theme.
ImU32 on_badge() {
    return theme::used() == Theme::dark ? IM_COL32_BLACK : IM_COL32_WHITE;
}

void draw_mark(ImDrawList& list, ImVec2 c, float half) {
    const float thick = std::max(half * 0.22F, 1.0F);
    list.AddLine(c + ImVec2(0, -half * 0.45F), c + ImVec2(0, half * 0.2F), on_badge(), thick);
    list.AddCircleFilled(c + ImVec2(0, half * 0.5F), thick * 0.6F, on_badge());
}

}  // namespace

void draw_warning(ImDrawList& list, ImVec2 c, float size, ImU32 color) {
    const float half = size * 0.5F;
    list.AddTriangleFilled(c + ImVec2(0, -half), c + ImVec2(half, half * 0.85F),
                           c + ImVec2(-half, half * 0.85F), color);
    draw_mark(list, c + ImVec2(0, half * 0.12F), half);
}

void draw_error(ImDrawList& list, ImVec2 c, float size, ImU32 color) {
    const float half = size * 0.5F, cut = half * 0.42F;
    const ImVec2 corners[] = {c + ImVec2(-cut, -half), c + ImVec2(cut, -half),
                              c + ImVec2(half, -cut),  c + ImVec2(half, cut),
                              c + ImVec2(cut, half),   c + ImVec2(-cut, half),
                              c + ImVec2(-half, cut),  c + ImVec2(-half, -cut)};
    list.AddConvexPolyFilled(corners, 8, color);
    draw_mark(list, c, half);
}

}  // namespace wrinkle::editor
