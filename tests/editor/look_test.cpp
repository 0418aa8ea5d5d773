// Tests of text rendering at every zoom and scale: glyphs are drawn at their baked size or slightly
// smaller, and text is as wide as at zoom 1 times the zoom.
#include "editor/view/look/look.h"

#include <cmath>

#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "editor/view/look/magnified.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

struct Letters {
    size_t count = 0;
    float least = 10, most = 0;  // screen pixels per texel of the font texture
    float low = 1e9F, high = -1e9F;
};

// Measures the textured quads of a draw list, which are glyphs: six indices for four corners.
void measure(const ImDrawList& list, float scale, Letters& letters) {
    const auto wide = static_cast<float>(ImGui::GetIO().Fonts->TexWidth);
    for (const ImDrawCmd& command : list.CmdBuffer)
        for (unsigned i = 0; i + 6 <= command.ElemCount; i += 3) {
            const ImDrawIdx* index = &list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
            if (index[3] != index[0] || index[4] != index[2] || index[5] != index[0] + 3) continue;
            const ImDrawVert* a = &list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
            if (a[0].uv.x >= a[1].uv.x || a[0].uv.y >= a[2].uv.y) continue;
            const float texels = (a[1].uv.x - a[0].uv.x) * wide;
            const float ratio = (a[1].pos.x - a[0].pos.x) * scale / texels;
            letters.least = std::min(letters.least, ratio);
            letters.most = std::max(letters.most, ratio);
            letters.low = std::min(letters.low, a[0].pos.x);
            letters.high = std::max(letters.high, a[1].pos.x);
            ++letters.count;
        }
}

constexpr int zoom_steps = 40;
float zoom_at_step(int step) {
    return 0.35F * std::pow(4 / 0.35F, static_cast<float>(step) / (zoom_steps - 1));
}

TEST_F(Headless, LettersOfTheCanvasAreNeverMagnifiedAndHardlyShrunk) {
    open(small_graph);
    for (int step = 0; step < zoom_steps; ++step) {
        state.view.zoom = zoom_at_step(step);
        state.view.pan = {100, 100};
        frame();
        Letters letters;
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i)
            if (std::string_view(data.CmdLists[i]->_OwnerName) == "##canvas")
                measure(*data.CmdLists[i], 1, letters);
        EXPECT_LE(letters.most, 1.001F) << state.view.zoom;
        EXPECT_GE(letters.least, 0.799F) << state.view.zoom;
        EXPECT_GE(letters.count, state.view.zoom > 0.4F ? 10U : 0U) << state.view.zoom;
    }
}

TEST_F(Headless, AZoomedTextIsAsWideAsTheZoomSays) {
    const std::string_view text = "Tangent normal map, 12.0 per m";
    for (const bool bold : {false, true})
        for (int step = 0; step < zoom_steps; ++step) {
            const float zoom = zoom_at_step(step);
            if (16 * zoom < min_text) continue;
            ImDrawList list(ImGui::GetDrawListSharedData());
            list._ResetForNewFrame();
            list.PushTextureID(ImGui::GetIO().Fonts->TexID);
            list.PushClipRect({-9999, -9999}, {9999, 9999});
            draw_magnified(list, state.fonts, {16, bold}, zoom, {0, 0}, theme::text, text);
            Letters letters;
            measure(list, 1, letters);
            const float width = magnified_width(state.fonts, {16, bold}, text);
            EXPECT_NEAR((letters.high - letters.low) / zoom, width, 2 + 2 / zoom) << zoom;
        }
}

TEST_F(Headless, AllDigitsAreEquallyWide) {
    for (const bool bold : {false, true})
        for (const float size : {14.0F, 16.0F}) {
            const float zero = magnified_width(state.fonts, {size, bold}, "0");
            for (const char digit : {'1', '4', '7'})
                EXPECT_EQ(magnified_width(state.fonts, {size, bold}, std::string(1, digit)), zero);
        }
}

TEST_F(Headless, EveryScaleKeepsTheGraphAndItsLetters) {
    open(small_graph);
    const float zoom = state.view.zoom;
    const ImVec2 at = state.layout.find("softer")->at;
    for (const float scale : interface_scales) {
        state.look.scale = scale;
        frame();
        frame();
        EXPECT_EQ(state.view.zoom, zoom);
        EXPECT_EQ(state.layout.find("softer")->at.x, at.x);
        Letters letters;
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i)
            measure(*data.CmdLists[i], scale, letters);
        EXPECT_GT(letters.count, 100U);
        EXPECT_LE(letters.most, 1.001F) << scale;
        EXPECT_GE(letters.least, 0.75F) << scale;
        play("assert clean\nassert target field:softer.amount");
        if (scale > 1.5F) continue;
        play("key Home\nwheel canvas 3");
        play("drag field:softer.amount field:softer.amount+10,0\nassert dirty\nkey Ctrl+Z");
        state.view.zoom = zoom;
    }
}

TEST_F(Headless, ThemeAndScaleAreCommands) {
    open(small_graph);
    const ImU32 dark = theme::canvas;
    EXPECT_TRUE(run_command(state, "light-theme"));
    frame();
    EXPECT_NE(theme::canvas, dark);
    EXPECT_TRUE(run_command(state, "dark-theme"));
    frame();
    EXPECT_EQ(theme::canvas, dark);
    play("key Ctrl+Shift+Up\nkey Ctrl+Shift+Up");
    EXPECT_EQ(state.look.scale, 1.5F);
    play("key Ctrl+Shift+Down\nkey Ctrl+Shift+Down\nkey Ctrl+Shift+Down");
    EXPECT_EQ(state.look.scale, 1);
    for (int i = 0; i < 9; ++i)
        run_command(state, "larger");
    EXPECT_EQ(state.look.scale, 3);
}

}  // namespace
}  // namespace wrinkle::editor
