// Tests of sub-graphs made from selected nodes: group and ungroup.
#include "editor/model/document/group.h"
#include "editor/model/document/wiring.h"
#include "editor/view/edit/edits.h"
#include "graph/read.h"
#include "graph/write.h"
#include "headless.h"
#include "random_graph.h"

namespace wrinkle::editor {
namespace {

TEST_F(Headless, AGroupKeepsAllWiresAndCanBeOpened) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play(R"(
        key Ctrl+G
        assert status Group in group.json
        assert node group
        assert nodes 3
        assert wire noise.height group.gradient
        assert wire group.normal normal
        assert errors 0
        key Ctrl+Z
        assert clean
        assert wire softer.gradient normal.gradient
        key Ctrl+Shift+Z
        assert node group
        click node:group
        key Tab
        assert clean
        assert nodes 2
        assert wire input.gradient softer.gradient
        assert wire normal.normal normal
        assert errors 0
        key Shift+Tab
        assert nodes 3
        assert dirty
        assert errors 0)");
    EXPECT_TRUE(state.parent_graphs.empty());
}

size_t wires_of(const Document& document) {
    size_t count = 0;
    each_wire(document, [&](const Connection&) { ++count; });
    return count;
}

TEST_F(Headless, UngroupingPutsTheNodesBack) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play(R"(
        key Ctrl+G
        click node:group
        key Ctrl+Shift+G
        assert nodes 4
        assert wire noise.height softer.gradient
        assert wire softer.gradient normal.gradient
        assert wire normal.normal normal
        assert value softer.amount 0.6
        assert errors 0
        key Ctrl+Z
        assert node group
        key Ctrl+Z
        assert clean)");
}

TEST_F(Headless, UngroupingRandomGroupsLosesNoWire) {
    open(small_graph);
    std::mt19937 random(8);
    int made = 0;
    for (int i = 0; i < 200; ++i) {
        const Document start = random_graph(random);
        state.history = History(start);
        state.model = make_model(start, folder.path(), built_in_registry());
        std::set<std::string> ids;
        for (const NodePtr& node : start.nodes)
            if (random() % 3 == 0) ids.insert(node->id);
        std::string why;
        const auto group = make_group(state.model, start, ids, "inner.json", why);
        if (!group) continue;
        ++made;
        folder.write("inner.json", write_document(group->inner));
        Document outer = group->outer;
        outer.file = (folder.path() / "graph.json").string();
        state.history = History(outer);
        state.model = make_model(outer, folder.path(), built_in_registry());
        state.view.selected = {group->node};
        ungroup_selected(state);
        EXPECT_EQ(state.history.at(), 1U) << state.status;
        EXPECT_EQ(bad_wires(state.document()), 0U) << write_document(state.document());
        EXPECT_EQ(state.document().nodes.size(), start.nodes.size());
        EXPECT_EQ(wires_of(state.document()), wires_of(start));
    }
    EXPECT_GT(made, 40);
}

TEST_F(Headless, ASecondGroupHasAFileOfItsOwn) {
    open(small_graph);
    folder.write("group.json", "mine");
    state.view.selected = {"softer"};
    play("key Ctrl+G\nassert node group2\nassert errors 0");
    EXPECT_EQ(text_of(folder.path() / "group.json"), "mine");
}

TEST_F(Headless, WhatWouldBeALoopIsNoGroup) {
    open(small_graph);
    state.view.selected = {"noise", "normal"};
    play("key Ctrl+G\nassert status comes back\nassert clean\nassert nodes 4");
}

TEST_F(Headless, GroupsOfRandomGraphsHaveNoWrongWires) {
    open(small_graph);
    std::mt19937 random(6);
    int made = 0;
    for (int i = 0; i < 200; ++i) {
        const Document start = random_graph(random);
        const Model model = make_model(start, ".", built_in_registry());
        std::set<std::string> ids;
        for (const NodePtr& node : start.nodes)
            if (random() % 4 == 0) ids.insert(node->id);
        std::string why;
        const auto group = make_group(model, start, ids, "inner.json", why);
        EXPECT_EQ(group.has_value(), why.empty()) << why;
        if (!group) continue;
        ++made;
        EXPECT_EQ(bad_wires(group->inner), 0U) << write_document(group->inner);
        EXPECT_EQ(bad_links(group->inner), 0U);
        EXPECT_EQ(bad_links(group->outer), 0U);
        EXPECT_EQ(group->inner.nodes.size() + group->outer.nodes.size(), start.nodes.size() + 1);
    }
    EXPECT_GT(made, 40);
}

}  // namespace
}  // namespace wrinkle::editor
