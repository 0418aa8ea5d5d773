// What the material costs, per card.
#include "editor/document/cost.h"

#include <cmath>

#include "editor/canvas/canvas.h"
#include "editor/canvas/painter.h"
#include "editor/look/heat.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

size_t count_of(const std::string& text, std::string_view word) {
    size_t count = 0;
    for (size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

Cost cost_of(const State& state, std::string_view node) {
    if (!state.built.costs) return {~0U, ~0U};
    return state.built.costs->nodes.at(state.document().nodes.index_of(node));
}

TEST_F(Headless, TheStatusSaysWhatTheMaterialCosts) {
    open(small_graph);
    frame();
    ASSERT_TRUE(state.built.costs);
    EXPECT_GT(state.built.costs->total.ops, 0U);
    play("assert target status:cost");
}

TEST_F(Headless, EveryNodeHasItsCost) {
    open(R"({"wrinkle": 1, "nodes": {
        "double": {"type": "vec3_add", "in": {"a": {"from": "surface.position"},
                                         "b": {"from": "surface.position"}}},
        "unread": {"type": "vec3_add", "in": {"a": {"from": "surface.position"}}}},
        "outputs": {"sum": {"from": "double.vector"}}})");
    EXPECT_EQ(cost_of(state, "double"), (Cost{0, 3}));
    EXPECT_EQ(cost_of(state, "unread"), Cost());
    EXPECT_EQ(state.built.costs->total, (Cost{0, 3}));
    EXPECT_EQ(in_words({1, 14}), "1 read · 14 ops");
    EXPECT_EQ(in_words({0, 1}), "1 op");
    EXPECT_EQ(in_words({2, 1234567}), "2 reads · 1,234,567 ops");
}

TEST_F(Headless, AGraphThatDoesNotCompileHasNoCost) {
    open(small_graph);
    EXPECT_GT(cost_of(state, "noise").ops, 100U);
    EXPECT_GT(cost_of(state, "softer").ops, 0U);
    EXPECT_EQ(cost_of(state, "number"), Cost());
    open(R"({"wrinkle": 1, "nodes": {"x": {"type": "nonsense"}},
        "outputs": {"normal": {"from": "x.normal"}}})");
    EXPECT_FALSE(state.built.costs);
}

// The reads of the text that is generated, in all graphs of one function; nodes and what the
// outputs need sum up to the total in all.
TEST_F(Headless, CostsAreThoseOfTheText) {
    size_t compared = 0;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(WRINKLE_SOURCE_DIR) / "graphs")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".json" || name.find(".test.") != name.npos) continue;
        const std::string text = text_of(entry.path());
        Diagnostics problems;
        const Model model = make_model(read_document(text, name, problems),
                                       entry.path().parent_path(), built_in_registry());
        const Build built = build(model, model.project->top(), built_in_registry(), "material");
        if (!built.uniform) continue;
        ASSERT_TRUE(built.costs) << name;
        Cost sum;
        for (const Cost& cost : built.costs->nodes)
            sum += cost;
        EXPECT_LE(sum.ops, built.costs->total.ops) << name;
        EXPECT_EQ(sum.reads, built.costs->total.reads) << name;
        EXPECT_GT(sum.ops * 10, built.costs->total.ops * 5) << name;
        const std::string& source = built.uniform->source;
        const size_t functions =
            count_of(source, "\nfloat ") + count_of(source, "\nvec") + count_of(source, "\nvoid ");
        if (functions > 1) continue;
        ++compared;
        EXPECT_EQ(count_of(source, "texture(") + count_of(source, "textureLod(") +
                      count_of(source, "textureGrad("),
                  built.costs->total.reads)
            << name;
    }
    EXPECT_GT(compared, 4U);
}

// Vertices of that colour that are drawn in the card's last row, or in its header.
size_t drawn(const State& state, std::string_view node, ImU32 color, bool header = false) {
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushClipRectFullScreen();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    draw_graph(state, list);
    const Card& card = *state.layout.find(node);
    const float y = header ? 0 : card.size.y - cost_height;
    const ImVec2 low = to_screen(state.view, card.at + ImVec2(4, y + 2));
    const ImVec2 high = to_screen(
        state.view, card.at + ImVec2(card.size.x - 4, y + (header ? header_height : cost_height)));
    size_t count = 0;
    for (const ImDrawVert& vertex : list.VtxBuffer)
        count += vertex.col == color && vertex.pos.x > low.x && vertex.pos.x < high.x &&
                 vertex.pos.y > low.y && vertex.pos.y < high.y;
    return count;
}

TEST_F(Headless, TheCardSaysItsCostAndTheHeatViewTintsIt) {
    open(small_graph);
    state.view.zoom = 1;
    frame();
    const size_t letters = drawn(state, "noise", theme::text_dim);
    EXPECT_GE(letters, 4 * std::string("123ops").size());
    const HeatColor hottest = heat_color(1), coldest = heat_color(0);
    EXPECT_EQ(drawn(state, "noise", hottest.ground), 0U);
    play("key H");
    EXPECT_GT(drawn(state, "noise", hottest.ground), 0U);
    EXPECT_GT(drawn(state, "noise", hottest.text), 0U);
    EXPECT_GT(drawn(state, "number", coldest.ground), 0U);
    play("key H");
    EXPECT_EQ(drawn(state, "noise", hottest.ground), 0U);
    state.built.costs.reset();
    EXPECT_EQ(drawn(state, "noise", theme::text_dim), 0U);
}

// The scale is even: it gets lighter from stop to stop, and its text reads on it.
TEST(Heat, GetsLighterAndItsTextReads) {
    const auto light = [](ImU32 color) {
        double sum = 0;
        const double weights[] = {0.2126, 0.7152, 0.0722};
        for (int i = 0; i < 3; ++i) {
            const double c = (color >> 8 * i & 255) / 255.0;
            sum += weights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
        }
        return sum;
    };
    double before = -1;
    for (int i = 0; i <= 90; ++i) {
        const HeatColor heat = heat_color(static_cast<float>(i) / 90);
        const double ground = light(heat.ground), text = light(heat.text);
        EXPECT_GT(ground, before);
        before = ground;
        EXPECT_GE((std::max(ground, text) + 0.05) / (std::min(ground, text) + 0.05), 4.5) << i;
    }
}

TEST_F(Headless, ThePreviewedNodeShowsAnEye) {
    open(small_graph);
    state.view.zoom = 1;
    EXPECT_EQ(drawn(state, "softer", theme::accent, true), 0U);
    state.view.selected = {"softer"};
    play("key P");
    state.view.selected.clear();
    EXPECT_GT(drawn(state, "softer", theme::accent, true), 10U);
    EXPECT_EQ(drawn(state, "noise", theme::accent, true), 0U);
    play("key P");
    EXPECT_EQ(drawn(state, "softer", theme::accent, true), 0U);
}

TEST_F(Headless, ARenamedNodeKeepsItsCost) {
    open(small_graph);
    const Cost before = cost_of(state, "noise");
    state.commit("Rename", rename_node(state.document(), "noise", "sound"));
    frame();
    ImDrawList list(ImGui::GetDrawListSharedData());
    const Painter painter(state, list);
    const Cost* cost = painter.cost(*state.layout.find("sound"));
    ASSERT_TRUE(cost);
    EXPECT_EQ(*cost, before);
}

TEST_F(Headless, ASubGraphCostsWhatItsNodesDo) {
    open(small_graph);
    const Cost total = state.built.costs->total;
    const Cost noise = cost_of(state, "noise"), softer = cost_of(state, "softer");
    state.view.selected = {"noise", "softer"};
    play("key Ctrl+G\nassert errors 0");
    EXPECT_EQ(state.built.costs->total, total);
    Cost both = noise;
    both += softer;
    EXPECT_EQ(cost_of(state, "group"), both);
}

}  // namespace
}  // namespace wrinkle::editor
