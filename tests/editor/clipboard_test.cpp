// Tests of the clipboard: copies are valid graph files with links and new ids; other text pastes
// nothing.
#include <algorithm>
#include <cmath>

#include "editor/model/document/files.h"
#include "editor/view/edit/clipboard.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"
#include "lower/check.h"

namespace wrinkle::editor {
namespace {

size_t errors_of(const std::string& text) {
    Diagnostics problems;
    const Document document = read_document(text, "clipboard", problems);
    const Model model = make_model(document, ".", built_in_registry());
    const Project project = project_with(model, document);
    check(project, built_in_registry(), Types(project, built_in_registry()), problems);
    return problems.error_count();
}

TEST_F(Headless, ACopyIsAGraphFileOfItsOwn) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play("key Ctrl+C\nassert status Copied 2 nodes\nassert clean");
    const std::string text = ImGui::GetClipboardText();
    EXPECT_EQ(errors_of(text), 0U) << text;
    EXPECT_NE(text.find("\"wrinkle\": 1"), text.npos);
    EXPECT_NE(text.find("\"from\": \"softer.gradient\""), text.npos);
    EXPECT_EQ(text.find("noise"), text.npos) << "what was not copied is not named";
}

TEST_F(Headless, PastingKeepsTheWiresOfItsOwnDocument) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play(R"(
        key Ctrl+C
        click canvas+0,250
        key Ctrl+V
        assert status Paste 2 nodes
        assert wire noise.height softer2.gradient
        assert wire softer2.gradient normal2.gradient
        assert value softer2.amount 0.6
        assert nodes 6
        key Ctrl+V
        assert node softer3
        key Ctrl+Z
        key Ctrl+Z
        assert clean)");
    EXPECT_EQ(write_document(state.document()), small_graph);
}

TEST_F(Headless, PastedNodesLandAtThePointerAndNeverExactlyOnOthers) {
    open(small_graph);
    state.view.selected = {"softer"};
    play("key Ctrl+C\nclick canvas+100,200\nkey Ctrl+V");
    const Card& card = *state.layout.find("softer2");
    const auto canvas = *state.targets.find("canvas");
    const float x = state.view.corner.x + state.view.pan.x + card.at.x * state.view.zoom;
    EXPECT_NEAR(x, canvas.middle_x() + 100, 8);
    for (int i = 0; i < 5; ++i)
        play("key Ctrl+V");
    const auto& cards = state.layout.cards;
    for (size_t a = 0; a < cards.size(); ++a)
        for (size_t b = a + 1; b < cards.size(); ++b)
            EXPECT_GT(std::max(std::fabs(cards[a].at.x - cards[b].at.x),
                               std::fabs(cards[a].at.y - cards[b].at.y)),
                      8)
                << cards[a].id << " and " << cards[b].id;
}

const char* const framed_graph = R"({ "wrinkle": 1, "nodes": {
    "a": { "type": "sine" }, "b": { "type": "sine" } },
    "layout": { "a": [0, 0], "b": [600, 0],
        "$frames": { "f": { "title": "Waves", "rect": [-40, -60, 260, 240] } },
        "$notes": { "n": { "text": "hello", "rect": [0, 320, 240, 96] } } } })";

bool is_inside(const Box& box, const Card& card) {
    return card.at.x > box.rect.x && card.at.y > box.rect.y &&
           card.at.x + card.size.x < box.rect.x + box.rect.width &&
           card.at.y + card.size.y < box.rect.y + box.rect.height;
}

TEST_F(Headless, FramesAndNotesAreCopiedWithTheirNodes) {
    open(framed_graph);
    const auto check_copies = [&] {
        ASSERT_EQ(state.document().frames.size(), 2U);
        ASSERT_EQ(state.document().notes.size(), 2U);
        const Box& frame = state.document().frames[1];
        EXPECT_EQ(frame.text, "Waves");
        EXPECT_EQ(state.document().notes[1].text, "hello");
        EXPECT_TRUE(is_inside(frame, *state.layout.find("a2")));
        EXPECT_NE(frame.rect, state.document().frames[0].rect);
        EXPECT_EQ(frame.rect.width, 260);
        EXPECT_EQ(state.view.boxes.size(), 2U);
        EXPECT_EQ(state.view.selected, std::set<std::string>{"a2"});
    };
    const auto select = [&] {
        state.view.selected = {"a"};
        state.view.boxes = {{false, "f"}, {true, "n"}};
    };
    select();
    play("key Ctrl+C\nassert status Copied 1 node, a frame and a note\nkey Ctrl+V");
    check_copies();
    play("key Ctrl+Z\nassert clean");
    select();
    play("key Ctrl+D\nassert status Duplicate");
    check_copies();
    play("key Ctrl+Z\nassert clean");
    select();
    play("key Ctrl+X\nassert nodes 1");
    EXPECT_TRUE(state.document().frames.empty());
    EXPECT_TRUE(state.document().notes.empty());
    play("key Ctrl+V\nassert nodes 2");
    EXPECT_EQ(state.document().frames.size(), 1U);
    EXPECT_TRUE(is_inside(state.document().frames[0], *state.layout.find("a")));
}

TEST_F(Headless, AFrameAloneIsCopiedTooAndNeverExactlyOnAnother) {
    open(framed_graph);
    state.view.boxes = {{false, "f"}};
    play("key Ctrl+C\nassert status Copied a frame");
    for (int i = 0; i < 4; ++i)
        play("key Ctrl+V");
    state.view.boxes = {{false, "f"}};
    state.view.selected = {"b"};
    play("key Ctrl+D");
    state.view.boxes = {{false, "f"}};
    state.view.selected = {"b"};
    play("key Ctrl+D\nassert nodes 4");
    const auto& frames = state.document().frames;
    ASSERT_EQ(frames.size(), 7U);
    for (size_t i = 0; i < frames.size(); ++i)
        for (size_t k = i + 1; k < frames.size(); ++k)
            EXPECT_GT(std::max(std::fabs(frames[i].rect.x - frames[k].rect.x),
                               std::fabs(frames[i].rect.y - frames[k].rect.y)),
                      8);
    const Card &first = *state.layout.find("b2"), &second = *state.layout.find("b3");
    EXPECT_GT(std::fabs(first.at.x - second.at.x), 8);
    EXPECT_EQ(frames[6].rect.x - frames[0].rect.x, second.at.x - 600);
}

TEST_F(Headless, PastedNodesFindTheWiresOfTheirOwnNames) {
    open(R"({ "wrinkle": 1, "nodes": {
        "a": { "type": "sine" }, "b": { "type": "sine" },
        "c": { "type": "sine", "in": { "angle": { "from": "a.result" } } },
        "c2": { "type": "sine", "in": { "angle": { "from": "b.result" } } } } })");
    state.view.selected = {"c2"};
    play("key Ctrl+C\nkey Ctrl+V\nassert wire b.result c3.angle");
    state.view.selected = {"c2", "c"};
    play("key Ctrl+C\nkey Ctrl+V\nassert wire a.result c4.angle\nassert wire b.result c5.angle");
}

TEST_F(Headless, InAnotherDocumentOutsideWiresAreDropped) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play("key Ctrl+C");
    open_file(state, folder.write("other.json", small_graph));
    play(R"(
        click canvas+0,250
        key Ctrl+V
        assert node softer2
        assert no-wire noise.height softer2.gradient
        assert wire softer2.gradient normal2.gradient
        assert errors 0)");
}

TEST_F(Headless, ACopyOutlivesAClipboardThatForgets) {
    state.keeping.folders = folders_below(folder.path());
    open(small_graph);
    state.view.selected = {"softer"};
    play("key Ctrl+C");
    ImGui::SetClipboardText("");
    state.clip = {};
    play("key Ctrl+V\nassert node softer2");
}

TEST_F(Headless, CuttingIsOneStepAndCanBePasted) {
    open(small_graph);
    state.view.selected = {"softer"};
    play(R"(
        key Ctrl+X
        assert no-node softer
        assert status Cut 1 node
        click canvas+0,250
        key Ctrl+V
        assert node softer
        assert wire noise.height softer.gradient
        key Ctrl+Z
        key Ctrl+Z
        assert clean)");
}

TEST_F(Headless, NoTextChangesAnythingUnlessItIsNodes) {
    open(small_graph);
    const std::string deep(100'000, '[');
    const std::string nobody =
        R"({"wrinkle":1,"nodes":{"a":{"type":"sine","in":{"angle":{"from":"b.x"}}}}})";
    const std::pair<std::string, const char*> texts[] = {
        {"hello", "holds no nodes; line 1"},
        {"{}", "holds no nodes"},
        {"[]", "holds no nodes"},
        {R"({"wrinkle":1,"nodes":{}})", "no nodes"},
        {R"({"wrinkle":2,"nodes":{"a":{"type":"sine"}}})", "holds no nodes"},
        {R"({"wrinkle":1,"nodes":{"a.b":{"type":"sine"}}})", "holds no nodes"},
        {R"({"wrinkle":1,"nodes":{"$x":{"type":"sine"}}})", "holds no nodes"},
        {R"({"wrinkle":1,"nodes":{"a":{"type":"sine","in":{"angle":{"from":"a.result"}}}}})", ""},
        {R"({"wrinkle":1,"nodes":{"a":{"type":"sine")", "holds no nodes"},
        {deep, "holds no nodes"},
        {std::string("\xff\xfe{}"), "holds no nodes"},
    };
    for (const auto& [text, why] : texts) {
        ImGui::SetClipboardText(text.c_str());
        state.status.clear();
        play("key Ctrl+V\nassert clean\nassert nodes 4");
        EXPECT_EQ(state.status.rfind("Nothing was pasted: ", 0), 0U) << text.substr(0, 60);
        EXPECT_NE(state.status.find(why), std::string::npos) << state.status;
    }
    ImGui::SetClipboardText(nobody.c_str());
    play("key Ctrl+V\nassert node a\nassert wires 3\nkey Ctrl+Z\nassert clean");
}

TEST_F(Headless, ANodeOfAMissingPluginIsPastedVerbatim) {
    open(small_graph);
    ImGui::SetClipboardText(
        R"({"wrinkle":1,"nodes":{"x":{"type":"acme_cracks","in":{"depth":1.50},"note":"keep"}}})");
    play("key Ctrl+V\nassert node x");
    const std::string text = write_document(state.document());
    EXPECT_NE(text.find("\"depth\": 1.50"), text.npos) << text;
    EXPECT_NE(text.find("\"note\": \"keep\""), text.npos) << text;
}

}  // namespace
}  // namespace wrinkle::editor
