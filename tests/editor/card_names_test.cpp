// Tests of cards drawn too small for their headers: names and dragging.
#include "editor/view/canvas/card_names.h"

#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

bool overlap(const Extent& a, const Extent& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

class SmallCards : public Headless {
protected:
    // Sets the zoom and centers the graph on the canvas.
    void zoom_to(float zoom) {
        View& view = state.view;
        view.zoom = zoom;
        view.pan = view.extent * 0.5F -
                   (state.layout.bounds.low + state.layout.bounds.high) * (0.5F * view.zoom);
        frame();
    }
    Extent on_screen(const Card& card) const {
        const ImVec2 low = to_screen(state.view, card.at);
        return {low, low + card.size * state.view.zoom};
    }
    void expect_no_name_over_another_thing() const {
        const std::vector<CardName> names = card_names(state);
        const auto& cards = state.layout.cards;
        for (const CardName& name : names) {
            for (size_t i = 0; i < cards.size(); ++i)
                EXPECT_TRUE(i == name.card || !overlap({name.low, name.high}, on_screen(cards[i])))
                    << name.text << " over " << cards[i].id << " at " << state.view.zoom;
            for (const CardName& other : names)
                EXPECT_TRUE(&name == &other ||
                            !overlap({name.low, name.high}, {other.low, other.high}))
                    << name.text << " over " << other.text << " at " << state.view.zoom;
        }
    }
};

// Rows of cards with names of several lengths, spaced as closely as Tidy does.
std::string named_cards(int count) {
    std::string nodes, places;
    for (int i = 0; i < count; ++i) {
        const std::string name =
            "\"node_" + std::string(static_cast<size_t>(i % 7), 'm') + std::to_string(i) + "\": ";
        const std::string comma = i + 1 < count ? ",\n" : "";
        nodes += name + R"({"type": "add"})" + comma;
        places += name + "[" + std::to_string(i % 20 * 208) + ", " + std::to_string(i / 20 * 160) +
                  "]" + comma;
    }
    return R"({"wrinkle": 1, "nodes": {)" + nodes + R"(}, "layout": {)" + places + "}}";
}

TEST_F(SmallCards, EachHasItsWholeNameWhereThereIsRoom) {
    open(small_graph);
    for (const float zoom : {0.34F, 0.2F, 0.09F}) {
        zoom_to(zoom);
        const std::vector<CardName> names = card_names(state);
        EXPECT_GE(names.size(), zoom < 0.1F ? 4U : state.layout.cards.size()) << zoom;
        for (const CardName& name : names) {
            const Card& card = state.layout.cards[name.card];
            const bool node = card.kind == Card::Kind::node;
            EXPECT_EQ(name.text, node || card.kind == Card::Kind::surface ? card.id : "output");
            EXPECT_GE(name.high.y - name.low.y, 14) << "letters stay readable";
        }
        expect_no_name_over_another_thing();
    }
}

TEST_F(SmallCards, NoNameCoversACardOrAnotherName) {
    open(named_cards(200));
    size_t named = 0;
    for (const float zoom : {0.34F, 0.28F, 0.2F, 0.14F, 0.09F, 0.05F}) {
        zoom_to(zoom);
        expect_no_name_over_another_thing();
        named += card_names(state).size();
    }
    EXPECT_GT(named, 400U) << "most are named while there is room";
}

TEST_F(SmallCards, NamesAreDrawn) {
    open(small_graph);
    zoom_to(0.3F);
    size_t letters = 0;
    for (const CardName& name : card_names(state))
        letters += name.text.size();
    const auto vertices = [] {
        const ImDrawData& data = *ImGui::GetDrawData();
        for (int i = 0; i < data.CmdListsCount; ++i)
            if (std::string_view(data.CmdLists[i]->_OwnerName) == "##canvas")
                return static_cast<size_t>(data.CmdLists[i]->VtxBuffer.Size);
        return size_t{0};
    };
    const size_t all = vertices();
    for (Card& card : state.layout.cards)
        card.reroute = true;  // has no name; drawn with more vertices than a rectangle
    EXPECT_TRUE(card_names(state).empty());
    EXPECT_GT(all, 4 * letters);
}

TEST_F(SmallCards, MoveWhereverTheyArePressed) {
    open(named_cards(200));
    for (const float zoom : {0.05F, 0.09F, 0.2F, 0.34F, 0.55F}) {
        zoom_to(zoom);
        for (size_t i = 0; i < state.layout.cards.size(); ++i) {
            const Card& card = state.layout.cards[i];
            if (card.kind != Card::Kind::node) continue;
            for (const float x : {0.2F, 0.5F, 0.8F})
                for (const float y : {0.05F, 0.35F, 0.65F, 0.95F}) {
                    const ImVec2 at(card.at.x + card.size.x * x, card.at.y + card.size.y * y);
                    const Hit hit = pick(state, to_screen(state.view, at));
                    ASSERT_TRUE(hit.kind == Hit::Kind::card || hit.kind == Hit::Kind::header)
                        << card.id << " at " << x << ", " << y << ", zoom " << zoom;
                    ASSERT_EQ(hit.card, i);
                }
        }
    }
}

TEST_F(SmallCards, ADragOnOneMovesItAndMakesNoWire) {
    open(small_graph);
    zoom_to(0.09F);
    const ImVec2 before = state.layout.find("softer")->at;
    play("drag node:softer+3,2 node:softer+43,32\nassert wires 3\nassert status Move");
    EXPECT_GT(state.layout.find("softer")->at.x, before.x + 100);
    play("key Ctrl+Z\nassert clean");
}

TEST_F(SmallCards, ThePointerShowsANameThatHasNoRoom) {
    open(named_cards(200));
    zoom_to(0.05F);
    ASSERT_LT(card_names(state).size(), 200U);
    const auto at = *state.targets.find("node:node_mmm45");
    queue.motion(at.middle_x(), at.middle_y());
    frame();
    frame();
    EXPECT_EQ(state.layout.cards[state.hovered.card].id, "node_mmm45");
    EXPECT_TRUE(state.targets.find("tip:node_mmm45"));
}

}  // namespace
}  // namespace wrinkle::editor
