// Tests of wires edited by drags and commands: delete with reconnect, cut, insert, lazy connect,
// swap. Each is one undo step.
#include "editor/model/document/wiring.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

TEST_F(Headless, ThePushOfTheOutputsCardIsUndoneWithItsGesture) {
    open(R"({"wrinkle": 1, "nodes": {
        "bump": {"type": "resolve"}, "loose": {"type": "face_viewer"}},
        "outputs": {"normal": {"from": "bump.normal"}},
        "layout": {"bump": [0, 0], "loose": [160, 320]}})");
    state.view.outputs_at = ImVec2(320, 0);
    state.layout_stale = true;
    frame();
    play("drag node:loose node:loose+40,-320\nassert wire loose.normal normal");
    const ImVec2 pushed = *state.view.outputs_at;
    EXPECT_GT(pushed.x, 320);
    for (int i = 0; i < 2; ++i) {
        play("key Ctrl+Z\nassert clean");
        EXPECT_EQ(state.view.outputs_at->x, 320);
        play("key Ctrl+Shift+Z\nassert dirty");
        EXPECT_EQ(state.view.outputs_at->x, pushed.x);
    }
}

TEST_F(Headless, DeletingHealsTheWireOrLeavesAGap) {
    open(small_graph);
    play(R"(
        click node:softer
        key Delete
        assert no-node softer
        assert wire noise.height normal.gradient
        assert errors 0
        key Ctrl+Z
        assert clean
        click node:softer
        key Shift+Delete
        assert no-node softer
        assert no-wire noise.height normal.gradient
        assert wires 1
        key Ctrl+Z
        assert clean
        click node:normal
        key Delete
        assert wire softer.gradient normal
        assert errors 0
        key Ctrl+Z
        click node:noise
        key Delete
        assert wires 2
        key Ctrl+Z
        assert clean)");
}

TEST_F(Headless, AMutedNodePassesOnWhatItsDeletionWouldConnect) {
    open(R"({ "wrinkle": 1, "nodes": {
        "noise": { "type": "gradient_noise" },
        "sum": { "type": "add", "in": { "a": 1, "b": { "from": "noise.value" } } } },
        "outputs": { "roughness": { "from": "sum.result" } } })");
    const std::string both = state.code.text.source;
    state.view.selected = {"sum"};
    play("key M\nassert errors 0\nwait");
    const std::string muted = state.code.text.source;
    EXPECT_NE(muted, both);
    EXPECT_NE(muted.find("noise"), muted.npos);
    play("key Ctrl+Z");
    state.view.selected = {"sum"};
    play("key Delete\nassert wire noise.value roughness\nwait");
    EXPECT_EQ(state.code.text.source, muted);
}

TEST_F(Headless, DeletionTakesTheFirstConnectedInputThatConverts) {
    open(R"({ "wrinkle": 1, "nodes": {
        "noise": { "type": "gradient_noise" },
        "bump": { "type": "gradient_from_height", "in": { "height": { "from": "noise.height" } } },
        "tilt": { "type": "gradient_scale", "in": { "gradient": { "from": "bump.gradient" } } },
        "normal": { "type": "resolve", "in": { "gradient": { "from": "tilt.gradient" } } } },
        "outputs": { "normal": { "from": "normal.normal" } } })");
    state.view.selected = {"bump"};
    play("key Delete\nassert wire noise.height tilt.gradient\nassert errors 0");
}

TEST_F(Headless, ARowOfDeletedNodesHealsAtOnce) {
    open(small_graph);
    play("key Ctrl+A");
    state.view.selected = {"softer", "normal"};
    play("key Delete\nassert wire noise.height normal\nassert errors 0\nassert nodes 2");
    play("key Ctrl+Z\nassert clean");
}

TEST_F(Headless, ALooseNodeDroppedOnAWireStandsInIt) {
    open(R"({ "wrinkle": 1, "nodes": {
        "noise": { "type": "gradient_noise" },
        "softer": { "type": "gradient_scale", "in": { "gradient": { "from": "noise.height" } } },
        "loose": { "type": "height_scale" }, "other": { "type": "sine" } },
        "layout": { "noise": [0, 0], "softer": [300, 0], "loose": [0, 400], "other": [300, 400] } })");
    play(R"(
        drag node:loose pin:softer.gradient+-60,-20
        assert wire noise.height loose.height
        assert wire loose.height softer.gradient
        assert wires 2
        assert status Insert loose)");
    EXPECT_FALSE(state.history.can_redo());
    const Card &softer = *state.layout.find("softer"), &loose = *state.layout.find("loose");
    EXPECT_GE(softer.at.x, loose.at.x + loose.size.x) << "the neighbour made room";
    play(R"(
        key Ctrl+Z
        assert clean
        assert wires 1
        drag node:noise node:noise+0,60
        assert status Move
        key Ctrl+Z
        assert clean)");
}

TEST_F(Headless, AStrokeCutsTheWiresThatItCrosses) {
    open(small_graph);
    play(R"(
        stroke Ctrl right out:noise.height+30,-40 out:noise.height+30,60
        assert no-wire noise.height softer.gradient
        assert wires 2
        assert status Cut 1 wire
        key Ctrl+Z
        assert clean
        stroke Ctrl right canvas+-300,300 canvas+300,300
        assert clean)");
}

TEST_F(Headless, ALazyDragConnectsWhatFitsBest) {
    open(small_graph);
    play(R"(
        stroke Alt right node:noise node:number
        assert wire noise.value number.a
        stroke Alt right node:noise node:number
        assert wire noise.value number.b
        stroke Alt right node:number node:$output
        assert wire number.result roughness
        stroke Alt right node:normal node:noise
        assert status No output of normal fits
        assert errors 0
        key Ctrl+Z
        key Ctrl+Z
        key Ctrl+Z
        assert clean)");
}

TEST_F(Headless, TheFirstNormalOrMaterialIsAnOutput) {
    open("{ \"wrinkle\": 1, \"outputs\": {} }");
    play("click canvas+-200,150\nkey Space\ntype smoothstep\nkey Enter\nassert wires 0");
    play("key Space\ntype gradient_from_height\nkey Enter\nkey Space\ntype resolve\nkey Enter");
    EXPECT_EQ(link_at(state.document(), "", "normal"), (Link{"resolve", "normal"}));
    state.view.selected.clear();
    play("key Space\ntype face_viewer\nkey Enter");
    EXPECT_EQ(link_at(state.document(), "", "normal"), (Link{"resolve", "normal"}));
    state.view.selected = {"resolve"};
    play("key Space\ntype face_viewer\nkey Enter");
    EXPECT_EQ(link_at(state.document(), "", "normal"), (Link{"face_viewer2", "normal"}));
    open("{ \"wrinkle\": 1, \"outputs\": {} }");
    play("key Space\ntype material\nkey Enter");
    EXPECT_EQ(link_at(state.document(), "", "material"), (Link{"material", "material"}));
}

TEST_F(Headless, TheNewNodeTakesTheSelectionOrTheWire) {
    open(small_graph);
    play(R"(
        click node:softer
        key Space
        type gradient_invert
        key Enter
        assert wire softer.gradient gradient_invert.gradient
        assert wires 4
        key Ctrl+Z
        assert clean
        click out:softer.gradient+30,0
        key Space
        type gradient_invert
        key Enter
        assert wire softer.gradient gradient_invert.gradient
        assert wire gradient_invert.gradient normal.gradient
        assert errors 0
        key Ctrl+Z
        assert clean)");
    state.view.selected = {"noise", "softer"};
    play(R"(
        key Space
        type gradient_add
        key Enter
        assert wire noise.height gradient_add.a
        assert wire softer.gradient gradient_add.b
        key Ctrl+Z
        assert clean)");
}

TEST_F(Headless, ACopyTakesItsInputsAlongOrNot) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play(R"(
        key Ctrl+D
        assert wire noise.height softer2.gradient
        assert wire softer2.gradient normal2.gradient
        assert wires 5
        key Ctrl+Z
        assert clean)");
    state.view.selected = {"softer", "normal"};
    play(R"(
        key Ctrl+Shift+D
        assert no-wire noise.height softer2.gradient
        assert wire softer2.gradient normal2.gradient
        key Ctrl+Z
        assert clean)");
}

TEST_F(Headless, InputsChangePlaces) {
    open(R"({ "wrinkle": 1, "nodes": {
        "one": { "type": "sine" },
        "sum": { "type": "subtract", "in": { "a": { "from": "one.result" }, "b": 3.5 } } } })");
    play(R"(
        click node:sum
        key Alt+S
        assert wire one.result sum.b
        assert value sum.a 3.5
        key Alt+S
        assert wire one.result sum.a
        assert value sum.b 3.5
        click node:one
        key Alt+S
        assert status No selected node)");
}

TEST_F(Headless, WhatFeedsANodeIsSelected) {
    open(small_graph);
    play("click node:softer\nkey L");
    EXPECT_EQ(state.view.selected, (std::set<std::string>{"noise", "softer"}));
    play("click node:softer\nkey Shift+L");
    EXPECT_EQ(state.view.selected, (std::set<std::string>{"normal", "softer"}));
}

TEST_F(Headless, AWireIsReroutedAndARerouteMoves) {
    open(small_graph);
    play(R"(
        double out:softer.gradient+30,0
        assert node reroute
        assert wire softer.gradient reroute.in
        assert wire reroute.out normal.gradient
        assert errors 0
        drag node:reroute node:reroute+0,64
        assert status Move
        key Ctrl+Z
        key Ctrl+Z
        assert clean
        stroke Shift right out:noise.height+30,-40 out:noise.height+30,60
        assert wire noise.height reroute.in
        assert wire reroute.out softer.gradient
        click node:reroute
        key Delete
        assert wire noise.height softer.gradient
        assert errors 0)");
}

TEST_F(Headless, ARerouteTakesOnlyWhatItsReadersTake) {
    open(R"({ "wrinkle": 1, "nodes": {
        "up": { "type": "combine_vec3" }, "number": { "type": "sine" },
        "bend": { "type": "reroute", "in": { "in": { "from": "number.result" } } },
        "bend2": { "type": "reroute", "in": { "in": { "from": "bend.out" } } },
        "sum": { "type": "add", "in": { "a": { "from": "bend2.out" } } } },
        "layout": { "up": [0, 0], "number": [0, 200], "bend": [300, 200], "bend2": [500, 200],
                    "sum": [700, 200] } })");
    play(R"(
        drag out:up.vector pin:bend.in
        assert no-wire up.vector bend.in
        assert status is not a float
        click node:number
        key Delete
        assert no-wire number.result bend.in
        assert wire bend2.out sum.a)");
}

TEST_F(Headless, AVectorThatIsLostAtARerouteLeavesNoWrongWire) {
    open(R"({ "wrinkle": 1, "nodes": {
        "up": { "type": "combine_vec3" },
        "bend": { "type": "reroute", "in": { "in": { "from": "up.vector" } } },
        "far": { "type": "vec3_scale", "in": { "vector": { "from": "bend.out" } } } } })");
    play("assert wires 2\nclick node:up\nkey Delete\nassert wires 0");
}

TEST_F(Headless, EscapeTakesEveryGestureBack) {
    open(small_graph);
    const std::pair<const char*, int> gestures[] = {{"", 0}, {"Ctrl", 1}, {"Alt", 1}, {"Shift", 1}};
    const auto from = *state.targets.find("node:softer");
    for (const auto& [modifier, button] : gestures) {
        if (*modifier) queue.key(key_named(modifier), true);
        queue.motion(from.middle_x(), from.middle_y());
        queue.button(button, true);
        queue.motion(from.middle_x() - 200, from.middle_y() + 150);
        while (!queue.empty())
            frame();
        frame();
        EXPECT_NE(state.gesture.kind, Gesture::Kind::none) << modifier;
        if (*modifier) queue.key(key_named(modifier), false);
        play("key Escape");
        EXPECT_EQ(state.gesture.kind, Gesture::Kind::none) << modifier;
        queue.button(button, false);
        play("assert clean\nassert wires 3");
    }
    EXPECT_EQ(write_document(state.document()), small_graph);
}

}  // namespace
}  // namespace wrinkle::editor
