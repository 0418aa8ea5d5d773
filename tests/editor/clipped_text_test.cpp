// No text of panels, dialogs and cards is cut at the right or left border of its box, at four
// window sizes. Text that scrolls or moves with the canvas is left out.
#include <array>
#include <set>

#include "headless.h"

namespace wrinkle::editor {
namespace {

struct Size {
    ImVec2 points;
    float scale;  // pixels per point
};
const Size sizes[] = {{{1280, 720}, 1}, {{1600, 900}, 1}, {{2560, 1440}, 1}, {{1920, 1080}, 2}};

// Text of the canvas and of lines of code may be cut.
bool may_be_cut(std::string_view owner) {
    return owner == "##canvas" || owner.find("##code") != std::string_view::npos;
}

// Returns the windows with glyphs that stick out of their clip rectangle sideways, with positions.
std::set<std::string> windows_with_cut_text() {
    std::set<std::string> found;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        if (may_be_cut(list._OwnerName)) continue;
        for (const ImDrawCmd& command : list.CmdBuffer)
            for (unsigned i = 0; i + 6 <= command.ElemCount; i += 3) {
                const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
                if (index[3] != index[0] || index[4] != index[2] || index[5] != index[0] + 3)
                    continue;
                const ImDrawVert* a =
                    &list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
                if (a[0].uv.x >= a[1].uv.x || a[0].uv.y >= a[2].uv.y) continue;  // no glyph
                const ImVec4 clip = command.ClipRect;
                if (a[2].pos.y <= clip.y || a[0].pos.y >= clip.w) continue;
                if (a[0].pos.x >= clip.x - 1 && a[1].pos.x <= clip.z + 1) continue;
                found.insert(std::string(list._OwnerName) + " at " +
                             std::to_string(static_cast<int>(a[0].pos.x)) + ", " +
                             std::to_string(static_cast<int>(a[0].pos.y)));
            }
    }
    return found;
}

class ClippedText : public Headless {
protected:
    void expect_none(const std::string& shown) {
        const std::set<std::string> found = windows_with_cut_text();
        std::string text;
        for (const std::string& window : found)
            text += window + "\n";
        const ImVec2 room = ImGui::GetIO().DisplaySize;
        EXPECT_EQ(text, "") << shown << ", " << room.x << " x " << room.y;
    }
    template <typename Check>
    void at_each_size(const Check& check) {
        for (const Size& size : sizes) {
            ImGui::GetIO().DisplaySize = size.points;
            ImGui::GetIO().DisplayFramebufferScale = {size.scale, size.scale};
            for (int i = 0; i < 4; ++i)
                frame();
            check();
        }
    }
};

TEST_F(ClippedText, NoneOnTheStartPage) {
    at_each_size([&] { expect_none("start page"); });
}

TEST_F(ClippedText, NoneWithAGraph) {
    open(text_of(std::filesystem::path(WRINKLE_SOURCE_DIR) / "graphs/materials/lava.json"));
    at_each_size([&] {
        expect_none("code");
        play("key Shift+E");
        expect_none("inputs");
        play("key Shift+E");
    });
}

TEST_F(ClippedText, NoneInDialogsAndLists) {
    open(small_graph);
    constexpr std::array<const char*, 12> keys = {
        "Space",  "Ctrl+P",       "Ctrl+H", "Ctrl+F",   "Ctrl+B", "Ctrl+Shift+E",
        "Ctrl+O", "Ctrl+Shift+S", "F1",     "Shift+F1", "7",      "S"};
    at_each_size([&] {
        for (const char* key : keys) {
            play(std::string("key ") + key + "\nwait 3");
            expect_none(key);
            play("key Escape\nwait 2");
        }
    });
}

}  // namespace
}  // namespace wrinkle::editor
