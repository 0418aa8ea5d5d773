// Tests of the window regions: sizes against a table of expected values, and changes by the user.
#include "editor/view/panels/regions.h"

#include "editor/view/commands/commands.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

struct Expected {
    ImVec2 window;
    float problems;  // height required by the rows
    ImVec2 canvas;
    float side, preview, below;
};

TEST(Regions, FollowTheTable) {
    const Expected table[] = {
        {{1280, 720}, 104, {880, 600}, 400, 352, 28},
        {{1920, 1080}, 104, {1344, 884}, 576, 524, 104},
        {{2560, 1440}, 104, {1792, 1244}, 768, 663, 104},
        {{2560, 1440}, 900, {1792, 1078}, 768, 663, 270},
    };
    for (const Expected& each : table) {
        const Regions r = find_regions({}, each.window, each.problems);
        EXPECT_EQ(r.canvas.size.x, each.canvas.x) << each.window.x;
        EXPECT_EQ(r.canvas.size.y, each.canvas.y) << each.window.x;
        EXPECT_EQ(r.preview.size.x, each.side) << each.window.x;
        EXPECT_EQ(r.preview.size.y, each.preview) << each.window.x;
        EXPECT_EQ(r.problems.size.y, each.below) << each.window.x;
        EXPECT_EQ(r.code.at.y + r.code.size.y, r.status.at.y);
        EXPECT_EQ(r.status.at.y + r.status.size.y, each.window.y);
    }
}

TEST(Regions, TheSideFoldsAwayInANarrowWindow) {
    EXPECT_EQ(find_regions({}, {900, 600}, 0).canvas.size.x, 900);
    EXPECT_EQ(find_regions({}, {900, 600}, 0).code.size.x, 0);
    Panes panes;
    panes.side_shown = true;
    EXPECT_EQ(find_regions(panes, {900, 600}, 0).canvas.size.x, 500);
    panes.side_shown = false;
    EXPECT_EQ(find_regions(panes, {1920, 1080}, 0).canvas.size.x, 1920);
}

TEST(Regions, AreOfSomeSizeInAnyWindow) {
    for (const float x : {1.0F, 200.0F, 533.0F, 5000.0F})
        for (const float y : {1.0F, 100.0F, 300.0F, 5000.0F})
            for (const float fraction : {0.0F, 0.02F, 0.98F, 50.0F, -3.0F}) {
                Panes panes;
                panes.side = panes.preview = panes.problems = fraction;
                panes.side_shown = true;
                const Regions r = find_regions(panes, {x, y}, 1e6F);
                for (const Pane pane : {Pane::canvas, Pane::problems, Pane::preview, Pane::code}) {
                    EXPECT_GE(r.of(pane).size.x, 0) << x << " " << y << " " << fraction;
                    EXPECT_GE(r.of(pane).size.y, 0) << x << " " << y << " " << fraction;
                }
            }
}

TEST_F(Headless, SplittersAreDraggedAndADoubleClickGivesTheRuleBack) {
    open(small_graph);
    const float before = state.view.extent.x;
    state.targets.add("splitter", {before - 1, 300, before + 2, 320});
    const auto drag = [&](float from, float to) {
        queue.motion(from, 310);
        queue.button(0, true);
        queue.motion(to, 310);
        queue.button(0, false);
        while (!queue.empty())
            frame();
        frame();
        frame();
    };
    drag(before, before - 160);
    EXPECT_NEAR(state.view.extent.x, before - 160, 8);
    const float now = state.view.extent.x;
    for (int i = 0; i < 2; ++i) {
        queue.motion(now, 310);
        queue.button(0, true);
        queue.button(0, false);
    }
    while (!queue.empty())
        frame();
    frame();
    frame();
    EXPECT_EQ(state.view.extent.x, before);
}

TEST_F(Headless, APanelIsMaximisedAndTheSideFolded) {
    open(small_graph);
    play("key F6\nassert clean");
    EXPECT_EQ(state.view.extent.x, 1600);
    play("key F6");
    EXPECT_LT(state.view.extent.x, 1600);
    EXPECT_TRUE(state.targets.find("line:1"));
    const auto canvas = *state.targets.find("canvas");
    queue.motion(canvas.middle_x(), canvas.middle_y());
    play("key F11");
    EXPECT_EQ(state.view.extent.x, 1600);
    EXPECT_FALSE(state.targets.find("line:1"));
    play("key F11");
    EXPECT_TRUE(state.targets.find("line:1"));
}

TEST_F(Headless, TheHeadOfThePreviewHasIcons) {
    open(small_graph);
    state.view.preview_view.distance = 3;
    play("click preview:frame");
    EXPECT_EQ(state.view.preview_view.distance, 1);
    play("click preview:maximise");
    EXPECT_EQ(regions_of(state).preview.size.x, ImGui::GetIO().DisplaySize.x);
    play("click preview:maximise\nclick preview:picture\nassert no-target browser:name");
    EXPECT_LT(regions_of(state).preview.size.x, ImGui::GetIO().DisplaySize.x);
    play("click compare:split\nclick preview:view\nclick view:normal");
    EXPECT_EQ(state.view.compare.mode, CompareView::Mode::split);
    EXPECT_EQ(state.view.preview_view.view, gpu::View::normal);
    state.panes.side = 0.45F;
    play("click view:uv");
    EXPECT_EQ(state.view.preview_view.view, gpu::View::uv);
}

TEST_F(Headless, TheBarsRunCommands) {
    open(small_graph);
    play(R"(
        click node:number
        click tool:delete
        assert no-node number
        assert status Delete
        click status:undo
        assert node number
        click search
        assert target palette:save
        key Escape
        click canvas:zoom-in)");
    const float zoom = state.view.zoom;
    play("click canvas:zoom-out");
    EXPECT_LT(state.view.zoom, zoom);
    play("click canvas:fit\nclick menu:View\nclick menu:light-theme");
    EXPECT_EQ(state.look.theme, Theme::light);
}

TEST_F(Headless, TheMinimapBringsAPlaceIntoTheMiddle) {
    open(small_graph);
    state.view.zoom = 2;
    frame();
    const ImVec2 before = state.view.pan;
    play("click minimap+-60,-20");
    EXPECT_NE(state.view.pan.x, before.x);
    const ImVec2 pan = state.view.pan;
    play("drag minimap+-60,-20 minimap+60,20");
    EXPECT_LT(state.view.pan.x, pan.x);
    play("assert clean");
}

TEST_F(Headless, NodesAreShownInThePlaceOfAMaximisedPanel) {
    open(small_graph);
    play("key Home");
    const float zoom = state.view.zoom;
    for (const char* key : {"Home", "F"}) {
        play(
            std::string("click node:noise\nclick preview:maximise\nassert no-target crumbs\nkey ") +
            key + "\nassert target crumbs");
        EXPECT_EQ(state.panes.maximised, Pane::none);
    }
    play("key Home");
    EXPECT_EQ(state.view.zoom, zoom);
}

TEST_F(Headless, EveryPanelIsDrawnInAWindowOfAnySize) {
    open(R"({"wrinkle": 1, "inputs": {"level": {"type": "float", "default": 0.5}}, "nodes": {
        "a": {"type": "no_such_type"}, "b": {"type": "reroute"}}, "outputs": {}})");
    state.panes.side_shown = state.inputs_panel.shown = true;
    state.panes.problems = 0.4F;
    for (const bool in_2d : {false, true}) {
        state.view.flat.on = in_2d;
        for (float side = 1; side < 560; ++side) {
            ImGui::GetIO().DisplaySize = {side, side};
            frame();
        }
        for (float tall = 90; tall < 400; ++tall) {
            ImGui::GetIO().DisplaySize = {900, tall};
            frame();
        }
    }
}

}  // namespace
}  // namespace wrinkle::editor
