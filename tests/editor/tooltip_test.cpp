// Tests of tooltips: position and visibility.
#include <imgui_internal.h>

#include "editor/view/canvas/layout.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

// Wrong values: `noise.scale` and `softer.amount` are texts; `noise.point` is a number.
const char* const faulty = R"({ "wrinkle": 1, "nodes": {
    "noise": { "type": "gradient_noise", "in": { "scale": "three", "point": 4 } },
    "softer": { "type": "gradient_scale", "in": { "gradient": { "from": "noise.height" },
        "amount": "a text that is far too long to be a number, so that its message is long too" } },
    "normal": { "type": "resolve", "in": { "gradient": { "from": "softer.gradient" } } } },
    "outputs": { "normal": { "from": "normal.normal" } },
    "layout": { "noise": [0, 0], "softer": [272, 0], "normal": [512, 0] } })";

class Tips : public Headless {
protected:
    static const ImGuiWindow* tip() {
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
            if ((window->Flags & ImGuiWindowFlags_Tooltip) && window->Active && !window->Hidden)
                return window;
        return nullptr;
    }
    void point(const TargetRect& at) {
        queue.motion(at.middle_x() - 2, at.middle_y());
        frame();
        queue.motion(at.middle_x(), at.middle_y());
        for (int i = 0; i < 70; ++i)
            frame();
    }
    // Returns "" if the target has a tooltip that does not cover it and is on the screen, else the
    // error.
    std::string wrong(const std::string& target) {
        const auto at = state.targets.find(target);
        if (!at) return target + " is not there";
        point(*at);
        const ImGuiWindow* window = tip();
        if (!window) return target + " has no tooltip";
        const ImVec2 low = window->Pos, high(low.x + window->Size.x, low.y + window->Size.y);
        if (low.x < at->x1 && at->x0 < high.x && low.y < at->y1 && at->y0 < high.y)
            return target + " is covered";
        const ImVec2 room = ImGui::GetIO().DisplaySize;
        if (low.x < 0 || low.y < 0 || high.x > room.x || high.y > room.y)
            return target + "'s tooltip leaves the screen";
        return "";
    }
};

TEST_F(Tips, CoverNothingThatTheyAreAbout) {
    open(small_graph);
    for (const char* target :
         {"field:softer.amount", "field:noise.scale", "node:softer", "out:noise.height",
          "pin:softer.gradient", "status:cost", "code:copy", "code:export"})
        EXPECT_EQ(wrong(target), "");
}

TEST_F(Tips, CoverNothingThatTheyAreAboutAtTheRightBorder) {
    open(small_graph);
    ImGui::GetIO().DisplaySize.x = 900;  // the canvas is as wide as the window
    frame();
    frame();
    state.view.zoom = 1;
    const Card& card = *state.layout.find("softer");
    state.view.pan = {state.view.extent.x - card.at.x - card.size.x - 4,
                      state.view.extent.y * 0.6F - card.at.y};
    frame();
    for (const char* target : {"node:softer", "out:softer.gradient"})
        EXPECT_EQ(wrong(target), "");
}

TEST_F(Tips, AMessageIsReadWithItsButton) {
    std::string graph = faulty;
    graph.replace(graph.find("gradient_noise"), 14, std::string(180, 'n'));
    open(graph);
    state.panes.problems = 300;
    play("wait 4");
    ASSERT_TRUE(state.targets.find("problem:1"));
    std::string seen;
    for (int i = 1; i <= 4; ++i) {
        const std::string target = "problem:" + std::to_string(i);
        const auto at = state.targets.find(target);
        if (!at) break;
        point({at->x0, at->y0, at->x0 + 300, at->y1});
        const ImGuiWindow* window = tip();
        if (!window) continue;  // the complete message is visible
        seen += target;
        EXPECT_LE(window->Pos.y + window->Size.y, state.targets.find("problem:1")->y0);
    }
    EXPECT_NE(seen, "") << "a message that is cut is shown in full";
}

TEST_F(Tips, AreGoneWhileANumberIsDragged) {
    open(small_graph);
    const auto at = *state.targets.find("field:softer.amount");
    point(at);
    EXPECT_TRUE(tip());
    queue.button(0, true);
    queue.motion(at.middle_x() + 30, at.middle_y());
    for (int i = 0; i < 90; ++i) {
        frame();
        EXPECT_FALSE(i > 1 && tip()) << i;
    }
    queue.button(0, false);
    play("wait");
}

TEST_F(Tips, AreGoneWhileTheMouseIsPressed) {
    open(small_graph);
    point(*state.targets.find("status:cost"));
    EXPECT_TRUE(tip());
    queue.button(0, true);
    for (int i = 0; i < 30; ++i) {
        frame();
        EXPECT_FALSE(i > 1 && tip()) << i;
    }
    queue.button(0, false);
    play("wait");
}

}  // namespace
}  // namespace wrinkle::editor
