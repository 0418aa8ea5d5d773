// Tests of copying a value to the selected nodes, by key and by menu.
#include "editor/view/commands/commands.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

const char* const four = R"({"wrinkle": 1, "nodes": {
    "a": {"type": "fbm", "in": {"scale": 3, "basis": "simplex"}},
    "b": {"type": "fbm", "in": {"scale": 5}},
    "c": {"type": "fbm", "in": {"scale": {"from": "input.size"}}},
    "ramp": {"type": "ramp"}},
    "inputs": {"size": {"type": "float", "default": 2}},
    "outputs": {"height": {"from": "a.height"}},
    "layout": {"a": [0, 0], "b": [400, 0], "c": [0, 500], "ramp": [400, 500]}})";

class CopiedValue : public Headless {
protected:
    void SetUp() override {
        open(four);
        frame();
    }
    double scale_of(const std::string& node) const {
        const Input* input = state.document().find(node)->find("scale");
        return input && input->kind == Input::Kind::literal ? input->value.as_number() : -1;
    }
};

TEST_F(CopiedValue, GoesToSelectedNodesOfItsTypeWithoutAWireInOneStep) {
    const std::string before = write_document(state.document());
    play("click field:a.scale\nkey Ctrl+A\nkey Shift+Enter");
    EXPECT_EQ(state.history.undo_name(), "Copy scale to 1 node");
    EXPECT_EQ(scale_of("b"), 3);
    EXPECT_EQ(state.document().find("c")->find("scale")->kind, Input::Kind::link);
    play("key Ctrl+Z");
    EXPECT_EQ(write_document(state.document()), before);
}

TEST_F(CopiedValue, OfADefaultResetsTheOthers) {
    play("key Ctrl+A\nright field:b.basis\nclick context:copy-value");
    EXPECT_EQ(state.document().find("a")->find("basis"), nullptr);
    EXPECT_EQ(state.history.undo_name(), "Copy basis to 2 nodes");
}

TEST_F(CopiedValue, IsNotOfferedWithoutTargetsOrAtAWire) {
    play("click field:a.scale");
    EXPECT_FALSE(find_command("copy-value")->enabled(state));
    play("key Ctrl+A\nright pin:c.scale\nassert no-target context:copy-value\nkey Escape");
    play("right field:a.scale\nassert target context:copy-value");
}

}  // namespace
}  // namespace wrinkle::editor
