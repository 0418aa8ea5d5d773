#include "editor/view/look/look.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wrinkle::editor {
namespace {

// Returns true for the six indices of a textured rectangle as written by PrimRectUV().
bool is_rectangle(const ImDrawIdx* index) {
    const int a = index[0];
    return index[1] == a + 1 && index[2] == a + 2 && index[3] == a && index[4] == a + 2 &&
           index[5] == a + 3;
}

bool is_letter(const ImDrawVert* corner) {
    return corner[0].uv.x < corner[1].uv.x && corner[0].uv.y < corner[2].uv.y &&
           corner[0].uv.y == corner[1].uv.y && corner[1].uv.x == corner[2].uv.x;
}

void sharpen(ImDrawList& list, const ImDrawCmd& command, float scale) {
    const unsigned end = command.IdxOffset + command.ElemCount;
    for (unsigned i = command.IdxOffset; i + 6 <= end; i += 3) {
        const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(i)];
        if (!is_rectangle(index)) continue;
        ImDrawVert* corner = &list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
        i += 3;
        if (!is_letter(corner)) continue;
        const float x = std::round(corner->pos.x * scale) / scale - corner->pos.x;
        const float y = std::round(corner->pos.y * scale) / scale - corner->pos.y;
        for (int k = 0; k < 4; ++k) {
            corner[k].pos.x += x;
            corner[k].pos.y += y;
        }
    }
}

}  // namespace

bool apply_look(const Look& look, Fonts& fonts) {
    if (theme::used() != look.theme) theme::use(look.theme);
    if (fonts.scale() == look.scale && fonts.generation() != 0) return false;
    fonts.load(look.scale);
    return true;
}

float next_scale(float scale, int by) {
    const auto first = std::begin(interface_scales), last = std::end(interface_scales);
    if (by > 0) {
        const auto next = std::upper_bound(first, last, scale);
        return next == last ? scale : *next;
    }
    const auto next = std::lower_bound(first, last, scale);
    return next == first ? scale : *std::prev(next);
}

void sharpen(ImDrawData& data, float scale) {
    if (scale == std::round(scale)) return;
    const ImTextureID letters = ImGui::GetIO().Fonts->TexID;
    for (int i = 0; i < data.CmdListsCount; ++i)
        for (const ImDrawCmd& command : data.CmdLists[i]->CmdBuffer)
            if (command.GetTexID() == letters && !command.UserCallback)
                sharpen(*data.CmdLists[i], command, scale);
}

}  // namespace wrinkle::editor
