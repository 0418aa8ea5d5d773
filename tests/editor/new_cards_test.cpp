// Tests of new cards: they cover no other card, are on top and visible; removed nodes are
// deselected.
#include <map>

#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "graph/edit.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

class NewCards : public Headless {
protected:
    // Lists the cards that `ids` cover, and those of `ids` not completely on the canvas; "" if
    // none.
    std::string wrong(const std::set<std::string>& ids) const {
        std::string found;
        const View& view = state.view;
        const ImVec2 end = view.corner + view.extent;
        for (const std::string& id : ids) {
            const Card* card = state.layout.find(id);
            if (!card) return found + " no " + id;
            for (const Card& other : state.layout.cards)
                if (&other != card && card->at.x < other.at.x + other.size.x &&
                    other.at.x < card->at.x + card->size.x &&
                    card->at.y < other.at.y + other.size.y &&
                    other.at.y < card->at.y + card->size.y)
                    found += " " + id + " over " + other.id;
            const ImVec2 low = to_screen(view, card->at);
            const ImVec2 high = low + card->size * view.zoom;
            if (low.x < view.corner.x || low.y < view.corner.y || high.x > end.x || high.y > end.y)
                found += " " + id + " out of sight";
        }
        return found;
    }
};

TEST_F(NewCards, CoverNoneAtTheSurfaceAndAtTheOutputs) {
    open(small_graph);
    for (const char* place :
         {"node:surface", "node:$output", "node:softer", "field:softer.amount"}) {
        play(std::string("click canvas+0,330\nright canvas+0,330\nkey Escape\nwait"));
        const auto at = *state.targets.find(place);
        queue.motion(at.middle_x() + 8, at.middle_y() + 12);
        play("key Space\ntype smoothstep\nkey Enter\nassert node smoothstep");
        EXPECT_EQ(wrong({"smoothstep"}), "") << place;
        play("key Ctrl+Z\nassert clean");
    }
}

TEST_F(NewCards, ComeInSightBehindTheSelectionAtTheBorder) {
    open(small_graph);
    state.view.zoom = 1;
    const Card& normal = *state.layout.find("normal");
    state.view.pan = state.view.extent - (normal.at + normal.size) - ImVec2(30, 300);
    state.view.selected = {"normal"};
    frame();
    play("key Space\ntype normal_angle\nkey Enter\nassert node normal_angle");
    EXPECT_EQ(wrong({"normal_angle"}), "");
}

TEST_F(NewCards, TheFirstOneLiesBetweenTheSurfaceAndTheOutputs) {
    open(R"({ "wrinkle": 1 })");
    const auto canvas = *state.targets.find("canvas");
    queue.motion(canvas.x1 - 60, canvas.y1 - 60);
    play("key Space\ntype material\nkey Enter\nwait 5");
    const Card& material = *state.layout.find("material");
    for (const Card& card : state.layout.cards) {
        EXPECT_TRUE(is_in_sight(state.view, card)) << card.id;
        if (card.kind == Card::Kind::surface) {
            EXPECT_LT(card.at.x + card.size.x, material.at.x);
        }
        if (card.kind == Card::Kind::outputs) {
            EXPECT_GT(card.at.x, material.at.x + material.size.x);
        }
    }
    EXPECT_EQ(state.layout.cards.size(), 3U);
    EXPECT_EQ(wrong({"material"}), "");
}

TEST_F(NewCards, BehindTheSelectionMoveTheOutputsToTheRight) {
    open(R"({ "wrinkle": 1 })");
    play("key Space\ntype bricks in bonds\nkey Enter\nwait 5");
    const auto outputs = [&] { return *state.layout.find(Card::outputs_id, Card::Kind::outputs); };
    const Card before = outputs();
    play("key Space\ntype bump from height\nkey Enter\nwait 5");
    const Card& bump = *state.layout.find("gradient_from_height");
    EXPECT_GT(bump.at.x, state.layout.find("bricks")->extent().high.x);
    EXPECT_EQ(bump.at.y, before.at.y);
    EXPECT_GT(outputs().at.x, bump.extent().high.x);
    EXPECT_EQ(outputs().at.y, before.at.y);
    EXPECT_EQ(wrong({"gradient_from_height"}), "");
    play("key Ctrl+Z");
    EXPECT_EQ(outputs().at.x, before.at.x);
}

TEST_F(NewCards, AreNotBehindThePanelOfProblemsNorTheMinimap) {
    open(small_graph);
    const auto canvas = *state.targets.find("canvas");
    queue.motion(canvas.x1 - 60, canvas.y1 - 60);
    const float before = state.view.extent.y;
    play("key Space\ntype fbm\nkey Enter\nwait 5");
    EXPECT_EQ(wrong({"fbm"}), "");
    const Card& card = *state.layout.find("fbm");
    const ImVec2 low = to_screen(state.view, card.at);
    EXPECT_FALSE(minimap_area(state.view).touches({low, low + card.size * state.view.zoom}));
    state.commit("Break", set_output(state.document(), "normal", {"number", "nothing"}));
    frame();
    play("wait 5");
    ASSERT_LT(state.view.extent.y, before);
    EXPECT_EQ(wrong({"fbm"}), "") << "after the panel of problems opened";
}

TEST_F(NewCards, DuplicatesLieBesideTheirOriginalsAndAboveAll) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play("key Ctrl+D\nassert nodes 6");
    EXPECT_EQ(wrong({"softer2", "normal2"}), "");
    EXPECT_TRUE(state.layout.cards.back().id == "softer2" ||
                state.layout.cards.back().id == "normal2");
    // Copies have the same relative positions as the originals.
    const Card &a = *state.layout.find("softer"), &b = *state.layout.find("normal");
    const Card &c = *state.layout.find("softer2"), &d = *state.layout.find("normal2");
    EXPECT_EQ(d.at.x - c.at.x, b.at.x - a.at.x);
    EXPECT_EQ(d.at.y - c.at.y, b.at.y - a.at.y);
    play("key Ctrl+D\nassert nodes 8");
    EXPECT_EQ(wrong({"softer2", "normal2", "softer3", "normal3"}), "");
}

TEST_F(NewCards, LeaveThoseWithoutAPlaceInTheFileWhereTheyAre) {
    std::string graph = small_graph;
    graph.erase(graph.find(",\n  \"layout\""), graph.rfind('}') - graph.find(",\n  \"layout\""));
    open(graph);
    ASSERT_TRUE(state.document().positions.size() == 0);
    std::map<std::string, std::pair<float, float>> before;
    for (const Card& card : state.layout.cards)
        before[card.id] = {card.at.x, card.at.y};
    play("click canvas+0,330\nkey Space\ntype smoothstep\nkey Enter\nassert node smoothstep");
    play("key Ctrl+D\nkey Ctrl+C\nkey Ctrl+V\nassert nodes 7");
    for (const Card& card : state.layout.cards)
        if (before.contains(card.id)) {
            EXPECT_EQ(card.at.x, before[card.id].first) << card.id;
            EXPECT_EQ(card.at.y, before[card.id].second) << card.id;
        }
    EXPECT_EQ(wrong({"smoothstep3"}), "");
}

TEST_F(NewCards, APasteOverACardLiesBesideIt) {
    open(small_graph);
    state.view.selected = {"softer"};
    play("key Ctrl+C\nclick node:normal\nkey Ctrl+V\nkey Ctrl+V\nassert nodes 6");
    EXPECT_EQ(wrong({"softer2", "softer3"}), "");
}

TEST_F(NewCards, AreNotSelectedOnceTheyAreGone) {
    open(small_graph);
    play("key Ctrl+A\nkey Ctrl+D\nassert nodes 8");
    EXPECT_EQ(state.view.selected.size(), 4U);
    play("key Ctrl+Z\nassert nodes 4");
    EXPECT_EQ(state.view.selected, std::set<std::string>());
    play("key C\nkey Enter");
    EXPECT_EQ(state.view.boxes.size(), 1U);
    play("key Ctrl+Z\nassert clean");
    EXPECT_TRUE(state.view.boxes.empty());
    play("click out:softer.gradient+30,0");
    EXPECT_TRUE(state.view.selected_wire);
    state.commit("cut", disconnect(state.document(), "normal", "gradient"));
    frame();
    EXPECT_FALSE(state.view.selected_wire);
}

TEST_F(NewCards, WhatStaysIsStillSelected) {
    open(small_graph);
    state.view.selected = {"softer", "surface", Card::outputs_id};
    state.commit("gone", remove_node(state.document(), "number"));
    frame();
    EXPECT_EQ(state.view.selected.size(), 3U);
}

}  // namespace
}  // namespace wrinkle::editor
