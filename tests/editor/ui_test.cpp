// Tests of the real window contents without a window; targets on the screen are found by name.
#include <random>

#include "editor/view/canvas/layout.h"
#include "editor/view/commands/commands.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

TEST_F(Headless, ShowsWhatTheGraphHolds) {
    open(small_graph);
    play(R"(
        assert nodes 4
        assert wires 3
        assert errors 0
        assert clean
        assert target node:noise
        assert target out:noise.height
        assert target pin:softer.gradient
        assert target field:softer.amount
        assert target pin:$output.normal
        assert target line:1
        assert code wrinkle_graph()");
    EXPECT_EQ(write_document(state.document()), small_graph);
}

TEST_F(Headless, ThePaletteAddsANodeAndUndoTakesItAway) {
    open(small_graph);
    play(R"(
        key Space
        type smooths
        assert target palette:smoothstep
        key Enter
        assert node smoothstep
        assert nodes 5
        key Ctrl+Z
        assert no-node smoothstep
        key Ctrl+Shift+Z
        assert node smoothstep
        click canvas+0,250
        key Space
        key Escape
        assert nodes 5)");
}

TEST_F(Headless, APinIsConnectedByADrag) {
    open(small_graph);
    play(R"(
        drag out:noise.value pin:number.a
        assert wire noise.value number.a
        assert wires 4
        drag pin:number.b out:noise.value
        assert wire noise.value number.b
        drag out:number.result pin:$output.roughness
        assert wire number.result roughness
        assert errors 0
        key Ctrl+Z
        assert no-wire number.result roughness)");
}

TEST_F(Headless, AWireThatFitsNobodyIsRefusedWithAReason) {
    open(small_graph);
    play(R"(
        drag out:normal.normal pin:number.a
        assert no-wire normal.normal number.a
        assert status is not a float
        drag out:normal.normal pin:softer.gradient
        assert status loop
        assert wires 3
        assert clean)");
}

TEST_F(Headless, AWireIsTakenOffAndPutElsewhereInOneStep) {
    open(small_graph);
    play(R"(
        drag pin:normal.gradient canvas+0,300
        assert no-wire softer.gradient normal.gradient
        key Ctrl+Z
        assert wire softer.gradient normal.gradient
        assert clean
        drag pin:softer.gradient pin:normal.gradient
        assert wire noise.height normal.gradient
        assert no-wire noise.height softer.gradient
        key Ctrl+Z
        assert wire noise.height softer.gradient
        assert clean
        click pin:softer.gradient
        assert clean
        drag pin:softer.gradient pin:softer.gradient+3,8
        assert clean)");
}

TEST_F(Headless, AWireIntoTheOpenAsksForANodeThatFits) {
    open(small_graph);
    play(R"(
        drag out:softer.gradient canvas+0,300
        assert target palette:gradient_add
        key Escape
        assert nodes 4
        drag out:softer.gradient canvas+0,300
        type gradient_add
        key Enter
        assert wire softer.gradient gradient_add.a)");
    EXPECT_FALSE(state.targets.find("palette:floor"));
}

TEST_F(Headless, AValueIsDraggedInOneStepAndCompilesNothingOnTheWay) {
    open(small_graph);
    const uint64_t builds = state.counters.builds;
    play("assert value softer.amount 0.6");
    const auto field = *state.targets.find("field:softer.amount");
    queue.motion(field.middle_x(), field.middle_y());
    queue.button(0, true);
    for (int i = 1; i <= 20; ++i) {
        queue.motion(field.middle_x() + static_cast<float>(i), field.middle_y());
        frame();
    }
    EXPECT_EQ(state.counters.builds, builds);
    EXPECT_GE(state.counters.uniforms, 10U);
    EXPECT_TRUE(state.dirty());
    queue.button(0, false);
    frame();
    frame();
    EXPECT_EQ(state.counters.builds, builds + 1);
    play("key Ctrl+Z\nassert value softer.amount 0.6\nassert clean");
    EXPECT_FALSE(state.history.can_undo());
}

TEST_F(Headless, EscapeGivesAValueBack) {
    open(small_graph);
    const auto field = *state.targets.find("field:softer.amount");
    queue.motion(field.middle_x(), field.middle_y());
    queue.button(0, true);
    queue.motion(field.middle_x() + 40, field.middle_y());
    while (!queue.empty())
        frame();
    EXPECT_TRUE(state.dirty());
    play("key Escape\nassert clean");
    queue.button(0, false);
    play("assert value softer.amount 0.6\nassert clean");
}

TEST_F(Headless, AValueIsTyped) {
    open(small_graph);
    play(R"(
        double field:softer.amount
        type 0.125
        key Enter
        assert value softer.amount 0.125
        double field:softer.amount
        type nonsense
        key Enter
        assert value softer.amount 0.125
        assert status is not a number)");
}

TEST_F(Headless, NodesAreMovedTogetherRenamedMutedAndDeleted) {
    open(small_graph);
    play(R"(
        key Ctrl+A
        drag node:softer node:softer+80,40)");
    const double dx = state.document().positions.find("noise")->x;
    EXPECT_NE(dx, 0);
    EXPECT_DOUBLE_EQ(state.document().positions.find("softer")->x, 272 + dx);
    EXPECT_DOUBLE_EQ(state.document().positions.find("number")->x, 272 + dx);
    play(R"(
        key Ctrl+Z
        assert clean
        click canvas+0,300
        double node:number
        type total
        key Enter
        assert node total
        assert no-node number
        click node:softer
        key M
        key Delete
        assert no-node softer
        assert wires 2
        key Ctrl+Z
        assert wires 3)");
    EXPECT_TRUE(state.document().find("softer")->muted);
}

TEST_F(Headless, MovingCompilesNothing) {
    open(small_graph);
    const uint64_t builds = state.counters.builds;
    play("drag node:number node:number+40,40\nassert dirty");
    EXPECT_EQ(state.counters.builds, builds);
}

TEST_F(Headless, TidyingPutsNoNodeOverAnother) {
    open(small_graph);
    play(R"(
        drag node:number node:noise
        key Ctrl+L
        assert dirty)");
    const auto& cards = state.layout.cards;
    for (size_t i = 0; i < cards.size(); ++i)
        for (size_t k = i + 1; k < cards.size(); ++k) {
            const Card &a = cards[i], &b = cards[k];
            const bool apart = a.at.x + a.size.x <= b.at.x || b.at.x + b.size.x <= a.at.x ||
                               a.at.y + a.size.y <= b.at.y || b.at.y + b.size.y <= a.at.y;
            EXPECT_TRUE(apart) << a.id << " and " << b.id;
        }
    play("key Ctrl+Z\nkey Ctrl+Z\nassert clean");
}

TEST_F(Headless, ABoxSelectsWhatItTouches) {
    open(small_graph);
    play("drag canvas+-480,-330 canvas+480,330");
    EXPECT_TRUE(state.view.selected.contains("noise"));
    EXPECT_TRUE(state.view.selected.contains("number"));
    play("click canvas+0,320");
    EXPECT_TRUE(state.view.selected.empty());
}

TEST_F(Headless, TheWheelZoomsAtThePointer) {
    open(small_graph);
    const auto before = *state.targets.find("node:softer");
    const float zoom = state.view.zoom;
    play("wheel node:softer -3");
    const auto after = *state.targets.find("node:softer");
    EXPECT_LT(state.view.zoom, zoom);
    EXPECT_NEAR(after.middle_x(), before.middle_x(), 1);
    EXPECT_NEAR(after.middle_y(), before.middle_y(), 1);
    play("assert clean");
}

TEST_F(Headless, PinsAreCaughtWhenZoomedFarOut) {
    open(small_graph);
    for (int i = 0; i < 8; ++i)
        play("wheel node:softer -1");
    EXPECT_LT(state.view.zoom, 0.5F);
    play("drag out:noise.value pin:number.a+-5,3\nassert wire noise.value number.a");
}

TEST_F(Headless, ANodeMayHaveTheNameOfTheOutputs) {
    std::string graph = small_graph;
    for (size_t at = graph.find("number"); at != graph.npos; at = graph.find("number"))
        graph.replace(at, 6, "output");
    open(graph);
    play(R"(
        click node:$output
        key Delete
        assert node output
        drag node:$output node:$output+40,40
        key M
        assert clean
        click node:output
        key Delete
        assert no-node output)");
}

TEST_F(Headless, LoopsAreFoundFromBothEnds) {
    open(small_graph);
    play(R"(
        drag pin:number.a out:number.result
        assert status number.result depends on number
        drag out:normal.normal pin:softer.gradient
        assert status normal.normal depends on softer
        assert clean)");
}

TEST_F(Headless, QuittingAsksOnlyWhenSomethingIsUnsaved) {
    open(small_graph);
    play(
        "click node:number\nkey Delete\nkey Ctrl+Q\nassert target answer:save\nclick "
        "answer:cancel");
    EXPECT_FALSE(state.quit);
    play("key Ctrl+Z\nassert clean\nkey Ctrl+Q");
    EXPECT_TRUE(state.quit);
}

TEST_F(Headless, CommandsAreFoundByName) {
    open(small_graph);
    play("key Ctrl+P\ntype select all\nkey Enter");
    EXPECT_EQ(state.view.selected.size(), 4U);
}

TEST(Commands, HaveNamesAndKeysOfTheirOwn) {
    std::set<std::string_view> ids, keys;
    for (const Command& command : commands()) {
        EXPECT_TRUE(ids.insert(command.id).second) << command.id;
        EXPECT_TRUE(command.keys.empty() || keys.insert(command.keys).second) << command.keys;
        EXPECT_FALSE(command.title.empty());
    }
}

TEST_F(Headless, AnyInputIsSurvived) {
    open(small_graph);
    std::mt19937 random(11);
    const auto number = [&](int below) {
        return static_cast<int>(random() % static_cast<unsigned>(below));
    };
    for (int i = 0; i < 6000; ++i) {
        switch (number(6)) {
            case 0:
            case 1:
                queue.motion(static_cast<float>(number(1600)), static_cast<float>(number(900)));
                break;
            case 2:
                queue.button(number(3), number(2) == 0);
                break;
            case 3:
                queue.wheel(0, static_cast<float>(number(3) - 1));
                break;
            case 4:
                queue.key(number(8) ? 'A' + number(26) : key_named("Delete"), number(2) == 0);
                break;
            default:
                queue.character(static_cast<unsigned>(' ' + number(90)));
                break;
        }
        frame();
        state.quit = false;
    }
    while (!queue.empty())
        frame();
    for (int i = 0; i < 512; ++i)
        ImGui::GetIO().KeysDown[i] = false;
    for (bool& down : ImGui::GetIO().MouseDown)
        down = false;
    frame();
    Diagnostics problems;
    const std::string text = write_document(state.document());
    const Document again = read_document(text, "again.json", problems);
    EXPECT_FALSE(problems.has_errors()) << to_text(problems) << text;
    EXPECT_EQ(write_document(again), text);
}

}  // namespace
}  // namespace wrinkle::editor
