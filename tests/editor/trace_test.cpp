// Tests of tracing: nodes and wires that are not on a path through the selection fade.
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/painter.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

class Trace : public Headless {
protected:
    std::set<std::string> faded() const {
        ImDrawList list(ImGui::GetDrawListSharedData());
        const Painter painter(state, list);
        std::set<std::string> names;
        for (size_t i = 0; i < state.layout.cards.size(); ++i)
            if (painter.fades(i)) names.insert(state.layout.cards[i].id);
        return names;
    }
    size_t faded_wires() const {
        ImDrawList list(ImGui::GetDrawListSharedData());
        const Painter painter(state, list);
        size_t count = 0;
        for (size_t i = 0; i < state.layout.wires.size(); ++i)
            count += painter.fades_wire(i);
        return count;
    }
    // Returns the largest alpha drawn in the card, 0 to 255. Precondition: the zoom is too small
    // for a grid.
    unsigned alpha_in(const std::string& node) {
        ImDrawList list(ImGui::GetDrawListSharedData());
        list._ResetForNewFrame();
        list.PushClipRectFullScreen();
        list.PushTextureID(ImGui::GetIO().Fonts->TexID);
        draw_graph(state, list);
        const Card& card = *state.layout.find(node);
        const ImVec2 low = to_screen(state.view, card.at);
        const ImVec2 high = to_screen(state.view, card.at + card.size);
        unsigned most = 0;
        for (const ImDrawVert& vertex : list.VtxBuffer)
            if (vertex.pos.x > low.x && vertex.pos.x < high.x && vertex.pos.y > low.y &&
                vertex.pos.y < high.y)
                most = std::max(most, vertex.col >> IM_COL32_A_SHIFT);
        return most;
    }
};

// noise -> a -> join -> normal, noise -> b -> join, and an unconnected node.
const char* const forked = R"({"wrinkle": 1, "nodes": {
    "noise": {"type": "gradient_noise"},
    "a": {"type": "gradient_scale", "in": {"gradient": {"from": "noise.height"}}},
    "b": {"type": "gradient_scale", "in": {"gradient": {"from": "noise.height"}}},
    "join": {"type": "gradient_add", "in": {"a": {"from": "a.gradient"},
                                            "b": {"from": "b.gradient"}}},
    "normal": {"type": "resolve", "in": {"gradient": {"from": "join.gradient"}}},
    "lone": {"type": "add"}},
    "outputs": {"normal": {"from": "normal.normal"}},
    "layout": {"noise": [0, 0], "a": [300, 0], "b": [300, 200], "join": [600, 0],
               "normal": [900, 0], "lone": [300, 600]}})";

TEST_F(Trace, LeavesTheWaysThroughTheSelection) {
    open(forked);
    EXPECT_TRUE(faded().empty());
    play("key T");
    EXPECT_TRUE(faded().empty()) << "nothing is selected";
    state.view.selected = {"a"};
    EXPECT_EQ(faded(), (std::set<std::string>{"b", "lone", "surface"}));
    EXPECT_EQ(faded_wires(), 2U);
    state.view.selected = {"join"};
    EXPECT_EQ(faded(), (std::set<std::string>{"lone", "surface"}));
    EXPECT_EQ(faded_wires(), 0U);
    state.view.selected = {"lone"};
    EXPECT_EQ(faded().size(), state.layout.cards.size() - 1);
    EXPECT_EQ(faded_wires(), state.layout.wires.size());
    play("key T");
    EXPECT_TRUE(faded().empty());
}

TEST_F(Trace, FadesToAThird) {
    open(forked);
    state.view.zoom = 0.45F;
    state.view.pan = {200, 100};
    state.view.selected = {"a"};
    frame();
    EXPECT_EQ(alpha_in("lone"), 255U);
    play("key T");
    EXPECT_EQ(alpha_in("lone"), 89U);
    EXPECT_EQ(alpha_in("join"), 255U);
}

}  // namespace
}  // namespace wrinkle::editor
