// Tests of the start page at every size of the window and of the interface.
#include "editor/view/panels/panels.h"

#include <imgui_internal.h>

#include "editor/model/document/files.h"
#include "editor/model/words.h"
#include "editor/view/look/draw.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

// Sets the size of the window, in screen pixels.
void resize(State& state, float width, float height) {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {width / state.look.scale, height / state.look.scale};
}

bool apart(const TargetRect& a, const TargetRect& b) {
    return a.x1 <= b.x0 || b.x1 <= a.x0 || a.y1 <= b.y0 || b.y1 <= a.y0;
}

TEST_F(Headless, TheStartPageHasOneLeftAndOneRightEdge) {
    state.start.read = true;
    state.start.techniques = list_samples(fs::path(WRINKLE_SOURCE_DIR) / "graphs");
    state.start.materials = list_samples(fs::path(WRINKLE_SOURCE_DIR) / "graphs/materials");
    new_file(state);
    for (const float scale : {1.0F, 1.5F, 2.0F, 3.0F})
        for (const ImVec2 window : {ImVec2(1280, 720), ImVec2(1920, 1080), ImVec2(800, 500)}) {
            state.look.scale = scale;
            frame();
            resize(state, window.x, window.y);
            frame();
            frame();
            const TargetRect drop = state.targets.find("start:drop").value();
            const TargetRect page = state.targets.find("canvas").value();
            EXPECT_GE(drop.x0, page.x0) << window.x << " at " << scale;
            EXPECT_LE(drop.x1, page.x1) << window.x << " at " << scale;
            float left = 1e9F, right = 0;
            std::vector<TargetRect> cards;
            for (const auto& [name, rect] : state.targets.all())
                if (name.starts_with("sample:")) cards.push_back(rect);
            ASSERT_EQ(cards.size(), state.start.techniques.size() + state.start.materials.size());
            for (size_t i = 0; i < cards.size(); ++i) {
                left = std::min(left, cards[i].x0);
                right = std::max(right, cards[i].x1);
                EXPECT_NEAR(cards[i].x1 - cards[i].x0, 168, 0.01F);
                EXPECT_NEAR(cards[i].y1 - cards[i].y0, 178, 0.01F);
                for (size_t j = 0; j < i; ++j)
                    EXPECT_TRUE(apart(cards[i], cards[j]));
            }
            EXPECT_NEAR(left, drop.x0, 0.01F) << window.x << " at " << scale;
            EXPECT_NEAR(right, drop.x1, 0.01F) << window.x << " at " << scale;
            EXPECT_NEAR(state.targets.find("start:new")->x0, drop.x0, 0.01F);
        }
}

TEST_F(Headless, TheNamesOfTheSamplesFitTheirCards) {
    ImFont* font = state.fonts.bold(14);
    for (const char* folder : {"graphs", "graphs/materials"})
        for (const Sample& sample : list_samples(fs::path(WRINKLE_SOURCE_DIR) / folder)) {
            const auto lines = wrapped(font, 14, sample.name, 148, 3);
            EXPECT_FALSE(lines.back().ends_with("...")) << sample.name;
        }
}

TEST_F(Headless, WrappedTextIsCutBetweenWordsAndNoLineIsTooLong) {
    ImFont* font = state.fonts.regular(16);
    const std::string text = "Pebbles, weave and a pattern of uv0 on three planes each";
    for (const float width : {60.0F, 100.0F, 148.0F, 300.0F, 900.0F})
        for (const size_t most : {1UL, 2UL, 9UL}) {
            const auto lines = wrapped(font, 16, text, width, most);
            EXPECT_LE(lines.size(), most);
            std::string joined;
            for (const std::string& line : lines) {
                EXPECT_LE(text_width(font, 16, line), width) << line;
                joined += (joined.empty() ? "" : " ") + line;
            }
            EXPECT_TRUE(joined == text || joined.ends_with("...")) << joined;
        }
    EXPECT_EQ(wrapped(font, 16, text, 148, 9).size(), 3U);
    EXPECT_TRUE(wrapped(font, 16, "", 148, 9).empty());
}

TEST_F(Headless, RecentFilesAreOpenedFromTheStartPage) {
    open(small_graph);
    new_file(state);
    frame();
    frame();
    ASSERT_TRUE(is_at_start(state));
    play("click start:recent1\nassert nodes 4");
    EXPECT_EQ(state.path.filename(), "graph.json");
}

TEST_F(Headless, AnEmptyGraphHasNoProblem) {
    new_file(state);
    state.start.left = true;
    frame();
    frame();
    EXPECT_TRUE(state.built.problems.list().empty()) << to_text(state.built.problems);
    play("assert errors 0\nassert no-target problem:1");
    open(R"({ "wrinkle": 1, "nodes": { "a": { "type": "add" } } })");
    EXPECT_EQ(state.built.problems.list().size(), 1U) << to_text(state.built.problems);
    EXPECT_FALSE(state.built.problems.has_errors());
}

}  // namespace
}  // namespace wrinkle::editor
