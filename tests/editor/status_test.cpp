// Tests of the status bar and of the cursor shape.
#include <imgui_internal.h>

#include "editor/model/document/files.h"
#include "editor/model/document/recovery.h"
#include "editor/model/words.h"
#include "editor/view/panels/panels.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

TEST(Words, AreForPeople) {
    EXPECT_EQ(milliseconds(0.72), "0.7 ms");
    EXPECT_EQ(milliseconds(1115.3), "1,115 ms");
    EXPECT_EQ(counted(1, "node"), "1 node");
    EXPECT_EQ(counted(1234567, "node"), "1,234,567 nodes");
    EXPECT_EQ(sentence("the graph has no outputs"), "The graph has no outputs.");
    EXPECT_EQ(sentence("weave: textures/weave.png was not found."),
              "weave: textures/weave.png was not found.");
    EXPECT_EQ(sentence("sum.a cannot feed b"), "sum.a cannot feed b.");
    EXPECT_EQ(sentence(""), "");
}

TEST_F(Headless, TheStatusSaysWhetherWorkIsKept) {
    new_file(state);
    frame();
    EXPECT_EQ(kept_words(state), "");
    open(small_graph);
    EXPECT_EQ(kept_words(state), "Saved");
    play("click node:number\nkey Delete");
    const std::string kept = kept_words(state);
    ASSERT_EQ(kept.size(), std::string("All edits kept 14:02").size()) << kept;
    EXPECT_EQ(kept.substr(0, 15), "All edits kept ");
    EXPECT_TRUE(state.targets.find("status:saved"));
    EXPECT_GT(state.targets.find("status:saved")->x0, state.view.extent.x);
    play("key Ctrl+S");
    EXPECT_EQ(kept_words(state), "Saved");
    state.recovery_file.remove();
    state.keeping.folders = {};
    play("click node:noise\nkey Delete");
    EXPECT_EQ(kept_words(state), "Not saved");
    state.keeping.unkept = "the disk is full";
    EXPECT_EQ(kept_words(state), "Edits are in memory alone");
}

TEST_F(Headless, TheHintIsOfWhatTheHandDoes) {
    open(small_graph);
    const auto hint = [&] { return std::string(hint_of(state, regions_of(state))); };
    const auto point = [&](const std::string& name) {
        const TargetRect rect = state.targets.find(name).value();
        queue.motion(rect.middle_x(), rect.middle_y());
        for (int i = 0; i < 3; ++i)
            frame();
        return hint();
    };
    EXPECT_NE(point("out:noise.height").find("connect"), std::string::npos);
    EXPECT_NE(point("field:softer.amount").find("type"), std::string::npos);
    EXPECT_NE(point("line:1").find("line"), std::string::npos);
    EXPECT_NE(point("preview").find("turns"), std::string::npos);
    queue.motion(3, 3);
    play("key Space");
    EXPECT_NE(hint().find("Pick a node"), std::string::npos) << hint();
    play("key Escape");
    const TargetRect pin = state.targets.find("out:noise.height").value();
    queue.motion(pin.middle_x(), pin.middle_y());
    queue.button(0, true);
    queue.motion(pin.middle_x() + 40, pin.middle_y() + 90);
    while (!queue.empty())
        frame();
    frame();
    EXPECT_NE(hint().find("Drop on a pin"), std::string::npos) << hint();
    queue.button(0, false);
    play("key Escape");
}

TEST_F(Headless, ThePointerShowsWhatCanBeDragged) {
    open(small_graph);
    const Regions regions = regions_of(state);
    const auto cursor_at = [&](ImVec2 place) {
        queue.motion(place.x, place.y);
        for (int i = 0; i < 3; ++i)
            frame();
        return ImGui::GetMouseCursor();
    };
    EXPECT_EQ(cursor_at({regions.preview.at.x, 300}), ImGuiMouseCursor_ResizeEW);
    EXPECT_EQ(cursor_at({200, regions.problems.at.y}), ImGuiMouseCursor_ResizeNS);
    EXPECT_EQ(cursor_at({200, 300}), ImGuiMouseCursor_Arrow);
    play("key Ctrl+O");
    const TargetRect name = state.targets.find("browser:name").value();
    EXPECT_EQ(cursor_at({name.middle_x(), name.middle_y()}), ImGuiMouseCursor_TextInput);
    play("key Escape");
}

}  // namespace
}  // namespace wrinkle::editor
