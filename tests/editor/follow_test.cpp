// Tests of data derived from the document: when source is generated, and that the interface does
// not wait.
#include "editor/model/document/files.h"
#include "editor/view/refresh.h"
#include "graph/edit.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

class Follows : public Headless {
protected:
    // Commits an edit and updates the derived data without drawing the code panel.
    void edit(Document document) {
        state.commit("edit", std::move(document));
        refresh(state);
    }
    uint64_t builds() const { return state.counters.builds; }
    bool text_has(const char* words) const {
        return state.built.uniform && state.built.uniform->source.find(words) != std::string::npos;
    }
};

Document with_amount(const Document& document, double amount) {
    return set_value(document, "softer", "amount", json::Value::number(amount));
}

TEST_F(Follows, MovingFramingAndRenamingMakeNoTextAndNoProgram) {
    open(small_graph);
    refresh(state);
    const uint64_t before = builds();
    const std::string running = state.follow.drawn.running()->source;
    edit(move_node(state.document(), "noise", 50, 60));
    edit(set_box(state.document(), &Document::frames,
                 {"frame", "Detail", {0, 0, 400, 300}, {}, {}}));
    edit(set_box(state.document(), &Document::notes,
                 {"note", "Look here", {0, 0, 200, 100}, {}, {}}));
    edit(rename_node(state.document(), "softer", "weaker"));
    edit(rename_node(state.document(), "normal", "resolved"));
    EXPECT_EQ(builds(), before);
    EXPECT_TRUE(is_settled(state));
    EXPECT_NE(state.type_of("weaker"), nullptr);
    EXPECT_EQ(state.follow.drawn.running()->source, running) << "another program runs";
}

TEST_F(Follows, ProblemsSpeakOfRenamedNodesByTheirNewNames) {
    open(small_graph);
    edit(set_value(state.document(), "number", "nonsense", json::Value::number(1)));
    ASSERT_EQ(state.built.problems.list().size(), 1U);
    edit(rename_node(state.document(), "number", "total"));
    ASSERT_EQ(state.built.problems.list().size(), 1U);
    EXPECT_EQ(state.built.problems.list()[0].node, "total");
}

TEST_F(Follows, ARenamedNodesValueStillReachesTheRunningProgram) {
    open(small_graph);
    edit(rename_node(state.document(), "softer", "weaker"));
    const uint64_t before = builds(), sent = state.counters.uniforms;
    state.gesture.kind = Gesture::Kind::value;  // a drag is in progress
    edit(set_value(state.document(), "weaker", "amount", json::Value::number(0.25)));
    EXPECT_EQ(builds(), before);
    EXPECT_EQ(state.counters.uniforms, sent + 1);
    state.gesture.kind = Gesture::Kind::none;
    refresh(state);
    EXPECT_EQ(builds(), before + 1) << "the texts follow";
}

TEST_F(Follows, ACompilerThreadHandsOverTheNewestText) {
    Compiler compiler(build);
    state.follow.compiler = &compiler;
    open(small_graph);
    compiler.wait_idle();
    frame();
    EXPECT_TRUE(text_has("softer_amount"));
    for (int i = 0; i < 40; ++i) {
        edit(rename_node(state.document(), "number", "n" + std::to_string(i)));
        edit(set_output(state.document(), i % 2 ? "roughness" : "metalness", {"noise", "value"}));
        state.commit("back", remove_output(state.document(), i % 2 ? "roughness" : "metalness"));
    }
    edit(set_output(state.document(), "occlusion", {"noise", "value"}));
    EXPECT_TRUE(state.building() || text_has("m.occlusion ="));
    compiler.wait_idle();
    refresh(state);
    EXPECT_TRUE(is_settled(state));
    EXPECT_TRUE(text_has("m.occlusion ="));
    EXPECT_FALSE(text_has("m.roughness ="));
    state.follow.compiler = nullptr;
}

TEST_F(Follows, TheFormerTextStaysWhileAnotherIsMade) {
    Compiler compiler(build);
    state.follow.compiler = &compiler;
    open(small_graph);
    play("assert code m.normal");
    state.commit("edit", set_output(state.document(), "roughness", {"noise", "value"}));
    refresh(state);  // requests a build; the current result is the previous one
    EXPECT_TRUE(text_has("m.normal"));
    play("assert code m.roughness");
    state.follow.compiler = nullptr;
}

TEST_F(Follows, AResultOfAnotherFileIsDropped) {
    Compiler compiler(build);
    state.follow.compiler = &compiler;
    open(small_graph);  // its source may not be generated yet
    const auto other = folder.write("other.json", R"({"wrinkle": 1, "nodes": {}})");
    open_file(state, other);
    refresh(state);
    compiler.wait_idle();
    refresh(state);
    EXPECT_TRUE(is_settled(state));
    EXPECT_FALSE(text_has("softer"));
    state.follow.compiler = nullptr;
}

TEST_F(Follows, ValuesThatChangeWhileTextsAreMadeArrive) {
    Compiler compiler(build);
    state.follow.compiler = &compiler;
    open(small_graph);
    play("assert code softer_amount");
    state.commit("edit", set_output(state.document(), "roughness", {"noise", "value"}));
    refresh(state);
    state.gesture.kind = Gesture::Kind::value;
    edit(with_amount(state.document(), 0.125));
    const uint64_t sent = state.counters.uniforms;
    compiler.wait_idle();
    refresh(state);
    refresh(state);
    EXPECT_GE(state.counters.uniforms, sent);
    EXPECT_TRUE(same_document(state.follow.sent_snapshot, state.document()));
    state.gesture.kind = Gesture::Kind::none;
    state.follow.compiler = nullptr;
}

}  // namespace
}  // namespace wrinkle::editor
