// Tests of opening and closing sub-graphs: the parent graphs remain unchanged.
#include "editor/model/document/levels.h"
#include "editor/view/lifecycle.h"

#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"
#include "graph/edit.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

// A node that is a sub-graph, and a number.
const char* const outer_graph = R"({"wrinkle": 1, "nodes": {
    "weave": {"type": "graph:weave.json"},
    "number": {"type": "add"}},
    "outputs": {"normal": {"from": "weave.normal"}},
    "layout": {"weave": [0, 0], "number": [0, 240]}})";
const char* const weave_graph = R"({"wrinkle": 1, "nodes": {
    "noise": {"type": "gradient_noise"},
    "thread": {"type": "graph:thread.json"},
    "normal": {"type": "resolve", "in": {"gradient": {"from": "thread.gradient"}}}},
    "outputs": {"normal": {"from": "normal.normal"}},
    "layout": {"noise": [0, 0], "thread": [272, 0], "normal": [512, 0]}})";
const char* const thread_graph = R"({"wrinkle": 1, "nodes": {
    "noise": {"type": "gradient_noise"},
    "softer": {"type": "gradient_scale", "in": {"gradient": {"from": "noise.height"}}}},
    "outputs": {"gradient": {"from": "softer.gradient"}},
    "layout": {"noise": [0, 0], "softer": [272, 0]}})";

class Levels : public Headless {
protected:
    void open_strap() {
        folder.write("weave.json", weave_graph);
        folder.write("thread.json", thread_graph);
        open(outer_graph);
        play("assert errors 0");
    }
    std::string disk(const char* name) const { return text_of(folder.path() / name); }
    size_t journals() const {
        size_t count = 0;
        std::error_code none;
        for (const auto& entry :
             fs::directory_iterator(state.keeping.folders.state / "journal", none))
            count += entry.path().extension() == ".journal";
        return count;
    }
};

TEST_F(Levels, GoingInLosesNothing) {
    open_strap();
    play("click node:number\nkey M\nassert dirty");
    state.view.pan = {123, 45};
    state.view.zoom = 0.75F;
    frame();
    const size_t steps = state.history.size();
    play("click node:weave\nkey Tab\nassert node thread\nassert clean");
    EXPECT_EQ(open_files(state), (std::vector<std::string>{"graph.json", "weave.json"}));
    play("click node:thread\nkey Enter\nassert node softer\nassert nodes 2");
    EXPECT_EQ(state.parent_graphs.size(), 2U);
    play("key Shift+Tab\nassert node thread\nkey Shift+Tab\nassert node number\nassert dirty");
    EXPECT_EQ(state.view.pan.x, 123);
    EXPECT_EQ(state.view.pan.y, 45);
    EXPECT_EQ(state.view.zoom, 0.75F);
    EXPECT_EQ(state.view.selected, std::set<std::string>{"weave"});
    EXPECT_EQ(state.history.size(), steps);
    play("assert errors 0\nkey Ctrl+Z\nassert clean");
    EXPECT_EQ(disk("graph.json"), outer_graph);
}

TEST_F(Levels, ADoubleClickGoesInAndOnTheNameRenames) {
    open_strap();
    play("double node:weave+0,24\nassert node thread");
    play("click crumb:0\nassert node number");
    const Card& card = *state.layout.find("weave");
    const ImVec2 name(card.at.x + 40, card.at.y + 14);
    const float x = state.view.corner.x + state.view.pan.x + name.x * state.view.zoom;
    const float y = state.view.corner.y + state.view.pan.y + name.y * state.view.zoom;
    queue.motion(x, y);
    for (int i = 0; i < 2; ++i) {
        queue.button(0, true);
        queue.button(0, false);
    }
    while (!queue.empty())
        frame();
    frame();
    EXPECT_EQ(state.popup.kind, Popup::Kind::rename);
    EXPECT_TRUE(state.parent_graphs.empty());
}

TEST_F(Levels, EachPartOfTheBreadcrumbGoesBack) {
    open_strap();
    play(R"(
        assert no-target crumb:1
        double node:weave+0,24
        double node:thread+0,24
        assert target crumb:0
        assert target crumb:1
        assert no-target crumb:2
        click crumb:1
        assert node thread
        double node:thread+0,24
        assert node softer
        click crumb:0
        assert node number
        assert no-target crumb:0)");
}

TEST_F(Levels, LeavingAsksAndSavingShowsNewPorts) {
    open_strap();
    play(R"(
        click node:number
        key M
        double node:weave+0,24
        click node:noise
        key Delete
        assert dirty
        key Shift+Tab
        assert target answer:save
        click answer:cancel
        assert node thread
        assert dirty
        key Shift+Tab
        click answer:save
        assert node number
        assert dirty
        key Ctrl+Z
        assert clean)");
    EXPECT_EQ(disk("weave.json").find("gradient_noise"), std::string::npos);
    play("double node:weave+0,24");
    GraphInput depth;
    depth.name = "depth";
    depth.type = "float";
    state.commit("Input", set_graph_input(state.document(), depth));
    play("key Shift+Tab\nclick answer:save\nassert target pin:weave.depth\nassert errors 0");
}

TEST_F(Levels, DiscardingKeepsTheFile) {
    open_strap();
    play(R"(
        double node:weave+0,24
        click node:noise
        key Delete
        key Shift+Tab
        click answer:discard
        assert node number
        assert clean)");
    EXPECT_EQ(disk("weave.json"), weave_graph);
    EXPECT_EQ(journals(), 0U);
    play("double node:weave+0,24\nassert node noise");
}

TEST_F(Levels, QuittingSavesAllLevels) {
    open_strap();
    play(R"(
        click node:number
        key M
        double node:weave+0,24
        click node:noise
        key M
        double node:thread+0,24
        click node:noise
        key M
        key Ctrl+Q
        assert target answer:save)");
    EXPECT_EQ(unsaved(state, state.question.then),
              (std::vector<std::string>{"thread.json", "weave.json", "graph.json"}));
    play("click answer:cancel\nassert node softer\nassert dirty\nkey Ctrl+Q\nclick answer:save");
    EXPECT_TRUE(state.quit);
    for (const char* name : {"graph.json", "weave.json", "thread.json"})
        EXPECT_NE(disk(name).find("\"muted\": true"), std::string::npos) << name;
    EXPECT_EQ(journals(), 0U);
}

TEST_F(Levels, ACleanInnerGraphDoesNotHideAnUnsavedOuterOne) {
    open_strap();
    play("click node:number\nkey M\ndouble node:weave+0,24\nassert clean\nkey Ctrl+N");
    play("assert target answer:save\nclick answer:discard\nassert nodes 0");
    EXPECT_TRUE(state.parent_graphs.empty());
    EXPECT_EQ(disk("graph.json"), outer_graph);
    EXPECT_EQ(journals(), 0U);
}

TEST_F(Levels, WhatCannotBeSavedStaysOpen) {
    open_strap();
    play(
        "click node:number\nkey M\ndouble node:weave+0,24\nclick node:noise\nkey M\nkey Ctrl+Q\n"
        "assert target answer:save");
    fs::remove(folder.path() / "weave.json");
    fs::create_directory(folder.path() / "weave.json");
    play("click answer:save");
    EXPECT_FALSE(state.quit);
    EXPECT_TRUE(state.question.open());
    play("click answer:later\nassert node thread\nassert dirty");
    EXPECT_EQ(state.parent_graphs.size(), 1U);
}

TEST_F(Levels, EachLevelHasItsRecoveryFile) {
    open_strap();
    play("click node:number\nkey M\nwait 2");
    EXPECT_EQ(journals(), 1U);
    play("double node:weave+0,24\nclick node:noise\nkey M\nwait 2");
    EXPECT_EQ(journals(), 2U);
    play("double node:thread+0,24\nclick node:noise\nkey M\nwait 2");
    EXPECT_EQ(journals(), 3U);
    std::set<std::string> graphs;
    for (const auto& entry : fs::directory_iterator(state.keeping.folders.state / "journal")) {
        const auto found = read_recovery_file(entry.path());
        ASSERT_TRUE(found);
        graphs.insert(found->graph.filename().string());
        EXPECT_NE(found->text.find("\"muted\": true"), std::string::npos) << found->graph;
    }
    EXPECT_EQ(graphs, (std::set<std::string>{"graph.json", "thread.json", "weave.json"}));
    play("key Ctrl+S\nkey Shift+Tab\nkey Ctrl+S\nkey Shift+Tab\nwait 2");
    EXPECT_EQ(journals(), 1U);
    play("key Ctrl+Z\nwait 2");
    EXPECT_EQ(journals(), 0U);
}

// The recovery files of a process that died inside a sub-graph are offered when the parent graph
// and the sub-graph are opened.
TEST_F(Levels, RecoveryHasAllLevels) {
    open_strap();
    play("click node:number\nkey M\ndouble node:weave+0,24\nclick node:noise\nkey M\nwait 2");
    fs::copy(state.keeping.folders.state / "journal", home.path() / "kept");
    finish(state);
    EXPECT_EQ(journals(), 0U);
    fs::remove_all(state.keeping.folders.state / "journal");
    fs::copy(home.path() / "kept", state.keeping.folders.state / "journal");
    carry_out(state, {PendingAction::Kind::open, file});
    play("assert target answer:recover\nclick answer:recover\nassert dirty");
    EXPECT_TRUE(state.document().find("number")->muted);
    play(
        "double node:weave+0,24\nassert target answer:recover\nclick answer:recover\nassert dirty");
    EXPECT_EQ(state.parent_graphs.size(), 1U);
    EXPECT_TRUE(state.document().find("noise")->muted);
    play("key Shift+Tab\nclick answer:save\nassert node number\nassert dirty");
    EXPECT_TRUE(state.document().find("number")->muted);
}

TEST_F(Levels, MissingFilesAndCirclesSayWhatIsWrong) {
    folder.write("weave.json", R"({"wrinkle": 1, "nodes": {
        "again": {"type": "graph:graph.json"}, "itself": {"type": "graph:weave.json"}},
        "layout": {"again": [0, 0], "itself": [0, 240]}})");
    open(R"({"wrinkle": 1, "nodes": {
        "weave": {"type": "graph:weave.json"}, "gone": {"type": "graph:parts/gone.json"}},
        "layout": {"weave": [0, 0], "gone": [0, 240]}})");
    state.view.selected = {"gone"};
    play("key Tab\nassert status gone: parts/gone.json was not found");
    EXPECT_TRUE(state.parent_graphs.empty());
    state.view.selected = {"weave"};
    play("key Tab\nassert node again");
    state.view.selected = {"again"};
    play("key Tab\nassert status graph.json holds itself: graph.json > weave.json > graph.json.");
    state.view.selected = {"itself"};
    play("key Tab\nassert status weave.json holds itself: weave.json > weave.json.");
    EXPECT_EQ(state.parent_graphs.size(), 1U);
}

// Names in a graph in a sub-folder are relative to that folder; they may lead up to the folder of
// the outermost graph.
TEST_F(Levels, TheOutermostGraphSaysHowFarNamesMayLead) {
    fs::create_directory(folder.path() / "parts");
    folder.write("thread.json", thread_graph);
    folder.write("parts/weave.json", R"({"wrinkle": 1, "nodes": {
        "thread": {"type": "graph:../thread.json"}},
        "outputs": {"gradient": {"from": "thread.gradient"}}, "layout": {"thread": [0, 0]}})");
    open(R"({"wrinkle": 1, "nodes": {"weave": {"type": "graph:parts/weave.json"}},
        "outputs": {"gradient": {"from": "weave.gradient"}}, "layout": {"weave": [0, 0]}})");
    play("assert errors 0\ndouble node:weave+0,24\nassert node thread\nassert errors 0");
    play("double node:thread+0,24\nassert node softer\nassert errors 0");
}

}  // namespace
}  // namespace wrinkle::editor
