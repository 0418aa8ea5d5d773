// Tests of frames, notes, lasso selection, scrolling during drags, alignment and search of nodes.
#include <set>

#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

ImVec2 place_of(const State& state, const char* id) {
    return state.layout.find(id)->at;
}

class Boxes : public Headless {
protected:
    void settle() {
        while (!queue.empty())
            frame();
        frame();
    }
    void press_at(float x, float y) {
        queue.motion(x, y);
        queue.button(0, true);
        settle();
    }
    void move_to(float x, float y) {
        queue.motion(x, y);
        settle();
    }
    void reset_interaction() {
        queue.button(0, false);
        settle();
    }
    const Rectangle& rect() const { return state.document().frames.begin()->rect; }
};

TEST_F(Boxes, AFrameGoesRoundTheSelectionInOneStep) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play("key C\ntype Detail\nkey Enter");
    ASSERT_EQ(state.document().frames.size(), 1U);
    EXPECT_EQ(state.document().frames.begin()->text, "Detail");
    const ImVec2 at = place_of(state, "softer");
    EXPECT_LT(rect().x, at.x);
    EXPECT_LT(rect().y, at.y - 30) << "room for the title";
    EXPECT_EQ(state.history.at(), 1U);
    play("key Ctrl+Z\nassert clean");
    EXPECT_EQ(write_document(state.document()), small_graph);
}

TEST_F(Boxes, AFrameMovesWithWhatStandsInIt) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play("key C\nkey Enter\nclick canvas+0,320");
    const uint64_t builds = state.counters.builds;
    const ImVec2 inside = place_of(state, "softer"), outside = place_of(state, "noise");
    const double x = rect().x;
    play("drag frame:frame frame:frame+0,-80\nassert status Move");
    const ImVec2 by = place_of(state, "softer") - inside;
    EXPECT_LT(by.y, -40);
    EXPECT_EQ(place_of(state, "noise").y, outside.y);
    EXPECT_DOUBLE_EQ(rect().x, x + by.x);
    EXPECT_EQ(state.counters.builds, builds) << "nothing is compiled for it";
    play("key Ctrl+Z");
    EXPECT_EQ(place_of(state, "softer").y, inside.y);
    play("click frame:frame\nkey Delete\nassert nodes 4\nassert wires 3");
    EXPECT_TRUE(state.document().frames.empty());
}

TEST_F(Boxes, AnEdgeResizesAndEscapeGivesItBack) {
    open(small_graph);
    state.view.selected = {"softer"};
    play("key C\nkey Enter");
    const Rectangle before = rect();
    const auto title = *state.targets.find("frame:frame");
    press_at(title.x1 - 1, title.middle_y());
    move_to(title.x1 + 60, title.middle_y());
    EXPECT_GT(rect().width, before.width + 30);
    EXPECT_DOUBLE_EQ(rect().x, before.x);
    play("key Escape");
    EXPECT_EQ(rect(), before);
    reset_interaction();
    press_at(title.x1 - 1, title.middle_y());
    move_to(title.x0 - 400, title.middle_y());
    reset_interaction();
    EXPECT_GE(rect().width, 64);
    play("key Ctrl+Z");
    EXPECT_EQ(rect(), before);
}

TEST_F(Boxes, ANoteIsWrittenAndWrittenAgain) {
    open(small_graph);
    play("click canvas+0,200\nkey N\ntype Keep it low\nkey Enter");
    ASSERT_EQ(state.document().notes.size(), 1U);
    EXPECT_EQ(state.document().notes.begin()->text, "Keep it low");
    play("double note:note\nkey Ctrl+A\ntype Other\nkey Enter");
    EXPECT_EQ(state.document().notes.begin()->text, "Other");
    play("key Ctrl+Z\nkey Ctrl+Z\nassert clean");
}

TEST_F(Boxes, ALassoSelectsWhatItGoesRound) {
    open(small_graph);
    const auto box = *state.targets.find("node:number");
    play(
        "click canvas+0,320\nstroke Ctrl+Shift left node:number+-120,-40 node:number+120,-40 "
        "node:number+120,150 node:number+-120,150");
    EXPECT_EQ(state.view.selected, std::set<std::string>{"number"}) << box.x0;
}

TEST_F(Boxes, ModifiersAddToTheBoxAndTakeFromIt) {
    open(small_graph);
    play("click node:noise\nstroke Shift left node:number+-130,90 node:number+0,0");
    EXPECT_EQ(state.view.selected, (std::set<std::string>{"noise", "number"}));
    play("stroke Ctrl left node:number+-130,90 node:number+0,0");
    EXPECT_EQ(state.view.selected, std::set<std::string>{"noise"});
}

TEST_F(Boxes, TheViewFollowsWhatIsDraggedToTheBorder) {
    open(small_graph);
    const auto node = *state.targets.find("node:number");
    const ImVec2 pan = state.view.pan;
    const float middle = state.view.corner.y + state.view.extent.y / 2;
    press_at(node.middle_x(), node.middle_y());
    move_to(state.view.corner.x + 4, middle);
    for (int i = 0; i < 30; ++i)
        frame();
    EXPECT_GT(state.view.pan.x, pan.x + 100);
    const auto moved = *state.targets.find("node:number");
    EXPECT_NEAR(moved.middle_x(), state.view.corner.x + 4, 8) << "it stays in the hand";
    play("key Escape\nassert clean");
    EXPECT_EQ(state.view.pan.x, pan.x);
    reset_interaction();
}

TEST_F(Boxes, PlacesAreBroughtInLine) {
    open(small_graph);
    play("key Ctrl+A\nkey Alt+Left");
    EXPECT_EQ(place_of(state, "noise").x, place_of(state, "number").x);
    play("key Ctrl+Z\nassert clean\nkey Alt+Down");
    const Card &a = *state.layout.find("noise"), &b = *state.layout.find("number");
    EXPECT_EQ(a.at.y + a.size.y, b.at.y + b.size.y);
    play("key Ctrl+Z\nassert clean");
    state.view.selected = {"noise", "softer", "normal"};
    play("key Ctrl+P\ntype distribute across\nkey Enter\nassert status Distribute");
    const Card &n = *state.layout.find("noise"), &s = *state.layout.find("softer"),
               &r = *state.layout.find("normal");
    EXPECT_NEAR(s.at.x - n.at.x - n.size.x, r.at.x - s.at.x - s.size.x, 1.5F);
    play("key Ctrl+Z\nassert clean");
    state.view.selected = {"noise", "softer"};
    const ImVec2 far = place_of(state, "normal");
    play("drag node:softer node:noise\nkey Ctrl+Shift+L\nassert status Tidy selection");
    EXPECT_EQ(place_of(state, "normal").x, far.x);
    EXPECT_GE(place_of(state, "softer").x,
              place_of(state, "noise").x + state.layout.find("noise")->size.x);
}

TEST_F(Boxes, ANodeIsFoundByIdTypeAndTitle) {
    open(small_graph);
    for (const char* query : {"norm", "resolve", "Resolve"}) {
        state.view.selected.clear();
        play("key Ctrl+F\ntype " + std::string(query) + "\nkey Enter\nassert clean");
        EXPECT_EQ(state.view.selected, std::set<std::string>{"normal"}) << query;
    }
}

}  // namespace
}  // namespace wrinkle::editor
