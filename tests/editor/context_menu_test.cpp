// Tests of the menus of cards, ports, wires and boxes, by mouse and by keyboard.
#include "editor/model/document/expose.h"
#include "editor/view/commands/commands.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

const char* const noise_bump = R"({"wrinkle": 1, "nodes": {
    "noise": {"type": "fbm", "in": {"scale": 3}},
    "bump": {"type": "gradient_from_height", "in": {"height": {"from": "noise.height"}}}},
    "outputs": {"normal": {"from": "bump.gradient"}},
    "layout": {"noise": [0, 0], "bump": [400, 0]}})";

class ContextMenus : public Headless {
protected:
    void SetUp() override { open(noise_bump); }
    std::string selected() const {
        std::string all;
        for (const std::string& id : state.view.selected)
            all += id + ";";
        return all;
    }
};

TEST_F(ContextMenus, AFieldIsExposedAndResetInOneStepEach) {
    const std::string before = write_document(state.document());
    play("right field:noise.scale\nassert target context:expose\nclick context:reset");
    play("assert no-target context:reset\nassert no-target context:expose");
    EXPECT_EQ(state.document().find("noise")->find("scale"), nullptr);
    EXPECT_EQ(state.history.undo_name(), "Reset noise.scale");
    play("right field:noise.scale\nassert no-target context:reset\nclick context:expose");
    play("assert wire input.scale noise.scale\nassert errors 0");
    play("key Ctrl+Z\nkey Ctrl+Z\nassert clean");
    EXPECT_EQ(write_document(state.document()), before);
}

TEST_F(ContextMenus, AConnectedPortIsDisconnected) {
    play("right pin:bump.height\nassert no-target context:expose\nclick context:disconnect");
    EXPECT_EQ(state.document().find("bump")->find("height"), nullptr);
    play(
        "key Ctrl+Z\nright pin:$output.normal\nassert no-target context:mute\n"
        "click context:disconnect");
    EXPECT_TRUE(state.document().outputs.empty());
    play("key Ctrl+Z\nassert clean");
}

TEST_F(ContextMenus, ACardOutsideTheSelectionIsSelected) {
    play("click node:noise\nright node:bump\nassert target context:mute");
    EXPECT_EQ(selected(), "bump;");
    play("key Escape\nassert no-target context:mute\nassert clean");
    play("key Ctrl+A\nright node:noise\nclick context:mute");
    EXPECT_TRUE(state.document().find("noise")->muted && state.document().find("bump")->muted);
}

TEST_F(ContextMenus, AWireIsBentAndDeleted) {
    play("right wire:bump.height\nclick context:bend");
    EXPECT_EQ(state.document().nodes.size(), 3U);
    play("key Ctrl+Z\nright wire:bump.height\nclick context:delete");
    EXPECT_EQ(state.document().find("bump")->find("height"), nullptr);
}

TEST_F(ContextMenus, AFrameIsRenamedAndDeleted) {
    play("click node:noise\nkey C\nassert target frame:frame");
    play(
        "key Escape\nclick canvas+20,300\nright frame:frame\nassert target context:text\nclick "
        "context:delete");
    EXPECT_TRUE(state.document().frames.empty());
    EXPECT_EQ(state.document().nodes.size(), 2U);
}

TEST_F(ContextMenus, TheKeyOpensItAndArrowsChoose) {
    play("click node:noise\nkey Shift+F10\nassert target context:mute\nkey Down\nkey Up\nkey Down");
    EXPECT_EQ(state.context_menu.chosen, 1);
    const std::string before = state.view.preview_request.node;
    play("key Enter\nassert no-target context:mute");
    EXPECT_NE(state.view.preview_request.node, before) << "preview-node is the second";
}

TEST_F(ContextMenus, KeysOfCommandsWaitUntilItIsClosed) {
    play("right node:noise\nkey M");
    EXPECT_FALSE(state.document().find("noise")->muted);
    play("key Escape\nkey M");
    EXPECT_TRUE(state.document().find("noise")->muted);
}

TEST_F(ContextMenus, APressElsewhereClosesIt) {
    play(
        "right node:noise\nassert target context:mute\nclick canvas+20,500\n"
        "assert no-target context:mute\nassert clean");
}

}  // namespace
}  // namespace wrinkle::editor
