// Tests of a canvas with thousands of nodes: counts of drawn vertices, targets and rebuilt cards.
#include <cmath>

#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "editor/view/refresh.h"
#include "graph/edit.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

// A chain of `count` additions, in rows of 40.
std::string sums(int count) {
    std::string nodes, places;
    for (int i = 0; i < count; ++i) {
        const std::string name = "\"n" + std::to_string(i) + "\": ";
        const std::string comma = i + 1 < count ? ",\n" : "";
        const std::string from =
            i > 0 ? R"("a": {"from": "n)" + std::to_string(i - 1) + ".result\"}" : "";
        nodes += name + R"({"type": "add", "in": {)" + from + "}}" + comma;
        places += name + "[" + std::to_string(i % 40 * 256) + ", " + std::to_string(i / 40 * 208) +
                  "]" + comma;
    }
    return R"({"wrinkle": 1, "nodes": {)" + nodes +
           R"(}, "outputs": {"height": {"from": "n1.result"}},
"layout": {)" +
           places + "}}";
}

size_t canvas_vertices() {
    size_t most = 0;
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int i = 0; i < data.CmdListsCount; ++i)
        if (std::string_view(data.CmdLists[i]->_OwnerName) == "##canvas")
            most = static_cast<size_t>(data.CmdLists[i]->VtxBuffer.Size);
    return most;
}

TEST_F(Headless, OnlyWhatIsSeenIsDrawn) {
    open(sums(2000));
    fit(state.view, state.layout, false);
    frame();
    const size_t all = canvas_vertices();
    EXPECT_GT(all, 2000U * 8);   // every card is drawn
    EXPECT_LT(all, 2000U * 40);  // as at most a rectangle and its wires
    state.view.zoom = 1;
    state.view.pan = {0, 0};
    frame();
    const size_t near = canvas_vertices();
    EXPECT_GT(near, 1000U);
    state.view.pan = {1e6F, 1e6F};
    frame();
    EXPECT_LT(canvas_vertices(), near / 4);
}

TEST_F(Headless, AllCardsAreInSightBelowThePathHoweverLargeTheGraph) {
    for (const float far : {0.0F, 900.0F, 20'000.0F, 400'000.0F}) {
        open(sums(3));
        state.commit("far", move_node(state.document(), "n2", double{far} + 512, double{far} / 2));
        frame();
        state.view.outputs_at = ImVec2(far + 900, far / 3);
        state.layout_stale = true;
        play("key Home");
        const View& view = state.view;
        const auto crumbs = *state.targets.find("crumbs");
        for (const Card& card : state.layout.cards) {
            const ImVec2 low = to_screen(view, card.at), high = low + card.size * view.zoom;
            EXPECT_GE(low.x, view.corner.x) << card.id << " of " << far;
            EXPECT_LE(high.x, view.corner.x + view.extent.x) << card.id << " of " << far;
            EXPECT_GE(low.y, crumbs.y1) << card.id << " of " << far;
            EXPECT_LE(high.y, view.corner.y + view.extent.y - 44) << card.id << " of " << far;
        }
        const float zoom = view.zoom;
        for (int i = 0; i < 3; ++i)
            play("wheel canvas -3");
        EXPECT_LE(view.zoom, zoom * 1.001F) << "the wheel reaches what shows all";
        EXPECT_GE(view.zoom, std::min(zoom, 0.05F) * 0.999F);
    }
}

TEST_F(Headless, AGraphOfAnyExtentIsDrawn) {
    for (const char* far : {"1e7", "1e15", "1e30", "1e38"})
        for (const char* near : {"0", "-1e38"}) {
            open(R"({"wrinkle": 1, "nodes": {"a": {"type": "reroute"}, "b": {"type": "add"}},
                "outputs": {}, "layout": {"a": [)" +
                 std::string(near) + ", 0], \"b\": [" + far + ", 0]}}");
            play("key Home\nwheel canvas -3");
            EXPECT_GT(state.view.zoom, 0) << far;
        }
}

TEST_F(Headless, TidyingBringsAllCardsInSight) {
    for (const char* how : {"key Ctrl+L", "click tool:tidy"}) {
        open(sums(3));
        state.commit("far", move_node(state.document(), "n2", 3000, -2000));
        frame();
        play(how);
        const View& view = state.view;
        for (const Card& card : state.layout.cards) {
            const ImVec2 low = to_screen(view, card.at), high = low + card.size * view.zoom;
            EXPECT_GE(low.x, view.corner.x) << card.id << " by " << how;
            EXPECT_GE(low.y, view.corner.y) << card.id << " by " << how;
            EXPECT_LE(high.x, view.corner.x + view.extent.x) << card.id << " by " << how;
            EXPECT_LE(high.y, view.corner.y + view.extent.y) << card.id << " by " << how;
        }
    }
}

TEST_F(Headless, CommandsUseTheLayoutOfTheNewestDocument) {
    open(sums(3));
    state.commit("Add", parsed(sums(60)));  // as the last event of a frame does
    queue.chord("Ctrl+L");
    while (!queue.empty())
        frame();
    frame();
    EXPECT_EQ(state.history.name(state.history.at()), "Tidy");
    std::set<std::pair<float, float>> positions;
    for (const Card& card : state.layout.cards)
        positions.insert({card.at.x, card.at.y});
    EXPECT_EQ(positions.size(), state.layout.cards.size());
}

TEST_F(Headless, NamesOnTheCanvasAreWorkedOutWhenAskedFor) {
    open(sums(2000));
    fit(state.view, state.layout, false);
    frame();
    EXPECT_LT(state.targets.all().size(), 200U);
    const auto last = state.targets.find("node:n1999");
    ASSERT_TRUE(last);
    const Card& card = *state.layout.find("n1999");
    EXPECT_FLOAT_EQ(last->x0, to_screen(state.view, card.at).x);
    EXPECT_TRUE(state.targets.find("pin:n7.a"));
    EXPECT_TRUE(state.targets.find("out:n7.result"));
    EXPECT_FALSE(state.targets.find("out:n7.a"));
    EXPECT_FALSE(state.targets.find("field:n7.b")) << "no field is shown from that far";
    EXPECT_FALSE(state.targets.find("node:n2000"));
    EXPECT_FALSE(state.targets.find("pin:"));
    EXPECT_FALSE(state.targets.find(""));
}

TEST_F(Headless, ACardIsMadeAnewOnlyWhenItsNodeHasChanged) {
    open(sums(400));
    EXPECT_EQ(state.layout.made, 400U);
    state.commit("move", move_node(state.document(), "n5", 8, 8));
    frame();
    EXPECT_EQ(state.layout.made, 0U);
    EXPECT_EQ(state.layout.find("n5")->at.x, 8);
    state.commit("value", set_value(state.document(), "n5", "b", json::Value::number(7)));
    frame();
    EXPECT_EQ(state.layout.made, 1U);
    EXPECT_EQ(state.layout.find("n5")->fields.at(0).value, "7");
    state.commit("wire", connect(state.document(), {"n9", "result"}, "n20", "b"));
    frame();
    EXPECT_EQ(state.layout.made, 2U);  // n20, and n9, which has a new user
    state.commit("delete", remove_node(state.document(), "n20"));
    frame();
    EXPECT_LE(state.layout.made, 4U);
    EXPECT_EQ(state.layout.find("n20"), nullptr);
    EXPECT_EQ(state.layout.find("n399")->id, "n399");
}

TEST_F(Headless, ADragMovesItsCardAndTheWiresAtIt) {
    open(sums(400));
    const Layout before = state.layout;
    state.view.selected = {"n5"};
    state.gesture.kind = Gesture::Kind::move;
    state.gesture.carried = {"n5"};
    state.gesture.offset = {40, 16};
    refresh(state);
    size_t moved = 0, bent = 0;
    for (size_t i = 0; i < before.cards.size(); ++i)
        moved += before.cards[i].at.x != state.layout.cards[i].at.x;
    for (size_t i = 0; i < before.wires.size(); ++i)
        bent += before.wires[i].start.x != state.layout.wires[i].start.x ||
                before.wires[i].end.x != state.layout.wires[i].end.x;
    EXPECT_EQ(moved, 1U);
    EXPECT_EQ(bent, 2U);
    EXPECT_EQ(state.layout.find("n5")->at.x, before.find("n5")->at.x + 40);
    state.gesture = {};
    refresh(state);
    EXPECT_EQ(state.layout.find("n5")->at.x, before.find("n5")->at.x);
}

// Hit tests at every pin and header of the layout: the search of nearby cards misses none.
TEST_F(Headless, EveryPinAndHeaderIsFoundUnderThePointer) {
    open(sums(200));
    for (const float zoom : {0.3F, 0.7F, 1.0F, 2.5F}) {
        state.view.zoom = zoom;
        for (size_t i = 0; i < state.layout.cards.size(); ++i) {
            const Card& card = state.layout.cards[i];
            for (const Pin& pin : card.pins) {
                const Hit hit = pick(state, to_screen(state.view, pin_at(card, pin)));
                ASSERT_EQ(hit.kind, Hit::Kind::pin) << card.id << "." << pin.port << " at " << zoom;
                const Card& found = state.layout.cards[hit.card];
                EXPECT_EQ(found.id + found.pins[hit.part].port, card.id + pin.port);
            }
            const Hit hit = pick(state, to_screen(state.view, {card.at.x + 60, card.at.y + 3}));
            EXPECT_EQ(hit.kind, Hit::Kind::header) << card.id << " at " << zoom;
            EXPECT_EQ(hit.card, i);
        }
        const Wire& wire = state.layout.wires.at(150);
        const ImVec2 middle((wire.start.x + wire.end.x) / 2, (wire.start.y + wire.end.y) / 2);
        const Hit hit = pick(state, to_screen(state.view, middle));
        EXPECT_EQ(hit.kind, Hit::Kind::wire) << zoom;
        EXPECT_EQ(hit.part, 150U);
    }
}

}  // namespace
}  // namespace wrinkle::editor
