// Tests of cards with many ports: folded, they show the first ports and those in use.
#include <algorithm>

#include "editor/view/canvas/layout.h"
#include "editor/view/canvas/make_card.h"
#include "editor/view/commands/commands.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

const char* const materials = R"({"wrinkle": 1, "nodes": {
    "gray": {"type": "add", "in": {"a": 0.5}},
    "paint": {"type": "material", "in": {"coat_weight": {"from": "gray.result"},
        "fuzz_weight": 0.25}},
    "parts": {"type": "material_split", "in": {"material": {"from": "paint.material"}}},
    "sum": {"type": "add", "in": {"a": {"from": "parts.coat_weight"}}}},
    "outputs": {"occlusion": {"from": "sum.result"}},
    "layout": {"gray": [-400, 0], "paint": [0, 0], "parts": [400, 0], "sum": [800, 0]}})";

std::vector<std::string> rows(const Card& card) {
    std::vector<std::string> names;
    for (const Pin& pin : card.pins)
        names.push_back(pin.port);
    return names;
}

bool has_row(const Card& card, const std::string& port) {
    return std::ranges::count(rows(card), port) > 0;
}

class FoldedCards : public Headless {
protected:
    void SetUp() override { open(materials); }
    const Card& card(const std::string& id) const { return *state.layout.find(id); }
};

TEST_F(FoldedCards, ALongCardShowsItsFirstPortsAndThoseInUse) {
    const std::vector<std::string> expected = {
        "material",  "base",   "normal",       "color",       "roughness",  "metalness",
        "occlusion", "height", "displacement", "coat_weight", "fuzz_weight"};
    EXPECT_EQ(rows(card("paint")), expected);
    EXPECT_EQ(card("paint").more, "35 more inputs");
    EXPECT_TRUE(has_row(card("parts"), "coat_weight"));
    EXPECT_FALSE(has_row(card("parts"), "fuzz_weight"));
    EXPECT_EQ(card("parts").more, "35 more outputs");
    EXPECT_EQ(card("sum").more, "");
    EXPECT_LT(card("paint").size.y, 400);
    EXPECT_EQ(state.layout.wires.size(), 4U);
}

TEST_F(FoldedCards, ItsLastRowUnfoldsItWithoutAnUndoStep) {
    const float folded = card("paint").size.y;
    play("click more:paint");
    EXPECT_EQ(rows(card("paint")).size(), 46U);
    EXPECT_EQ(card("paint").more, "fewer");
    play("key Home\nassert clean\nclick more:paint");
    EXPECT_EQ(card("paint").size.y, folded);
    EXPECT_EQ(state.layout.wires.size(), 4U);
}

TEST_F(FoldedCards, TheCommandTurnsAllSelectedLongCards) {
    play("click node:sum\nkey U");
    EXPECT_FALSE(find_command("ports")->enabled(state));
    EXPECT_EQ(card("paint").more, "35 more inputs");
    play("key Ctrl+A\nkey U");
    EXPECT_TRUE(card("paint").unfolded && card("parts").unfolded);
    play("key U");
    EXPECT_FALSE(card("paint").unfolded || card("parts").unfolded);
}

TEST_F(FoldedCards, AWireOnTheLastRowUnfoldsTheCard) {
    play(R"(stroke - left out:gray.result more:paint more:paint+9,2 more:paint+4,2
        assert wire gray.result paint.opacity)");
    EXPECT_TRUE(card("paint").unfolded);
    play("key Home\nclick more:paint");
    EXPECT_TRUE(has_row(card("paint"), "opacity"));
    play("key Ctrl+Z");
    EXPECT_FALSE(has_row(card("paint"), "opacity"));
}

TEST_F(FoldedCards, APortThatIsSetKeepsItsField) {
    const auto& fields = card("paint").fields;
    EXPECT_TRUE(std::ranges::count(fields, "fuzz_weight", &Field::port) == 1);
    play("double field:paint.fuzz_weight\nkey Ctrl+A\ntype 0.75\nkey Enter");
    play("assert value paint.fuzz_weight 0.75");
}

// A built-in node of 20 ports or fewer shows them all.
TEST(Folding, OnlyVeryLongNodesFold) {
    std::vector<std::string> long_ones;
    for (const NodeType& type : built_in_registry().list())
        if (type.ports.size() > most_rows) long_ones.push_back(type.id);
    std::ranges::sort(long_ones);
    EXPECT_EQ(long_ones, (std::vector<std::string>{"bricks", "material", "material_split", "ramp",
                                                   "splatter", "tile_sampler"}));
}

}  // namespace
}  // namespace wrinkle::editor
