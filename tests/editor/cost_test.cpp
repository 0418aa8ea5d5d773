// Tests of the material cost per card.
#include "editor/model/document/cost.h"

#include <imgui_internal.h>

#include <cmath>

#include "editor/model/document/files.h"
#include "editor/view/canvas/canvas.h"
#include "editor/view/canvas/painter.h"
#include "editor/view/look/theme.h"
#include "graph/edit.h"
#include "graph/read.h"
#include "headless.h"
#include "ir/cost.h"
#include "json/parse.h"

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
    const ShaderCost& cost =
        state.built.costs->nodes.at(state.document().nodes.index_of(node)).cost;
    return {cost.reads, cost.alu};
}
Cost estimate(const Build& built) {
    return {built.costs->total.cost.reads, built.costs->total.cost.alu};
}

TEST_F(Headless, TheStatusSaysWhatTheMaterialCosts) {
    open(small_graph);
    frame();
    ASSERT_TRUE(state.built.costs);
    EXPECT_GT(estimate(state.built).ops, 0U);
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
    EXPECT_EQ(estimate(state.built), (Cost{0, 3}));
    const auto words = [](uint32_t reads, uint32_t numbers, bool estimated) {
        return in_words({{.alu = numbers, .reads = reads}, 0}, estimated);
    };
    EXPECT_EQ(words(1, 14, false), "1 read · 14 ops");
    EXPECT_EQ(words(1, 14, true), "~1 read · ~14 ops");
    EXPECT_EQ(words(0, 1, false), "1 op");
    EXPECT_EQ(words(2, 1234567, false), "2 reads · 1,234,567 ops");
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

// The node costs sum to the total texture reads and to more than half of the total ops. If the
// generated source has a single function, the total equals its texture reads.
TEST_F(Headless, EstimatesAreThoseOfTheText) {
    size_t compared = 0;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(WRINKLE_SOURCE_DIR) / "graphs")) {
        const std::string name = entry.path().filename().string();
        if (entry.path().extension() != ".json" || name.find(".test.") != name.npos) continue;
        const std::string text = text_of(entry.path());
        Diagnostics problems;
        const Model model = make_model(read_document(text, name, problems),
                                       entry.path().parent_path(), built_in_registry());
        const Build built = build({0, model, model.project->top(), "material"});
        if (!built.uniform) continue;
        ASSERT_TRUE(built.costs) << name;
        Cost sum;
        for (const Price& price : built.costs->nodes)
            sum += {price.cost.reads, price.cost.alu};
        const Cost total = estimate(built);
        EXPECT_LE(sum.ops, total.ops) << name;
        EXPECT_EQ(sum.reads, total.reads) << name;
        EXPECT_GT(sum.ops * 10, total.ops * 5) << name;
        const std::string& source = built.uniform->source;
        const size_t helpers =
            count_of(source, "\nfloat ") + count_of(source, "\nvec") + count_of(source, "\nvoid ");
        if (helpers > 0) continue;
        ++compared;
        EXPECT_EQ(count_of(source, "texture(") + count_of(source, "textureLod(") +
                      count_of(source, "textureGrad("),
                  total.reads)
            << name;
    }
    EXPECT_GT(compared, 4U);
}

// Returns the number of vertices of that color in the card's last row or in its header.
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

// Luminance increases monotonically along the color scale, and its text has a contrast of at least
// 4.5.
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
    const Price* price = painter.price(*state.layout.find("sound"));
    ASSERT_TRUE(price);
    EXPECT_EQ(price->cost.alu, before.ops);
}

TEST_F(Headless, ASubGraphCostsWhatItsNodesDo) {
    open(small_graph);
    const Cost total = estimate(state.built);
    const Cost noise = cost_of(state, "noise"), softer = cost_of(state, "softer");
    state.view.selected = {"noise", "softer"};
    play("key Ctrl+G\nassert errors 0");
    EXPECT_EQ(estimate(state.built), total);
    Cost both = noise;
    both += softer;
    EXPECT_EQ(cost_of(state, "group"), both);
}

// With the counting thread, as in the window.
class Counted : public Headless {
protected:
    Counted() { state.follow.counter = &counter; }
    ~Counted() override { state.follow.counter = nullptr; }
    void settle() {
        counter.wait_idle();
        frame();
    }
    Price price_of(std::string_view node) const {
        return state.costs()->nodes.at(state.costs()->document.nodes.index_of(node));
    }
    static bool has_tooltip() {
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
            if (window->Active && (window->Flags & ImGuiWindowFlags_Tooltip)) return true;
        return false;
    }
    CostCounter counter{count, {}};
};

// The counts equal those that the program prints, in total and per node.
TEST_F(Counted, CostsAreThoseOfTheProgram) {
    for (const char* name : {"base_and_detail", "everything", "decals", "noise_rock"}) {
        const std::string sample = std::string(WRINKLE_SOURCE_DIR "/graphs/") + name + ".json";
        open_file(state, sample);
        frame();
        settle();
        ASSERT_TRUE(state.costs()) << name;
        ASSERT_FALSE(state.costs()->estimated) << name << state.costs()->why;
        Diagnostics problems;
        const json::Value cost =
            json::parse(program_output("compile --cost --json --params uniform " + sample), "cost",
                        problems)
                .root.find("graphs")
                .at(0)
                .find("cost");
        const Price& total = state.costs()->total;
        EXPECT_EQ(total.cost.alu, cost.find("total").find("alu").as_number()) << name;
        EXPECT_EQ(total.cost.reads, cost.find("total").find("texture_reads").as_number());
        EXPECT_EQ(total.texture_units, cost.find("total").find("texture_units").as_number());
        const json::Value nodes = cost.find("nodes");
        ASSERT_GT(nodes.size(), 2u);
        for (size_t i = 0; i < nodes.size(); ++i) {
            const Price price = price_of(nodes.at(i).find("node").as_string());
            EXPECT_EQ(price.cost.alu, nodes.at(i).find("alu").as_number()) << name;
            EXPECT_EQ(price.texture_units, nodes.at(i).find("texture_units").as_number());
        }
    }
}

// No frame waits: a new source has an estimate at once; after an edit the previous count is shown
// until the new one is done.
TEST_F(Counted, FollowTheTextWithoutHoldingItUp) {
    open(R"({"wrinkle": 1, "nodes": {"noise": {"type": "fbm"},
        "normal": {"type": "resolve", "in": {"gradient": {"from": "noise.height"}}}},
        "outputs": {"normal": {"from": "normal.normal"}}})");
    ASSERT_TRUE(state.costs());
    settle();
    const uint32_t counted = price_of("noise").cost.alu;
    EXPECT_FALSE(state.costs()->estimated);
    state.commit("Less",
                 set_value(state.document(), "noise", "basis", json::Value::string("value")));
    frame();
    ASSERT_TRUE(state.costs());
    EXPECT_FALSE(state.costs()->estimated);
    settle();
    EXPECT_LT(price_of("noise").cost.alu, counted * 3 / 4);
    open(R"({"wrinkle": 1, "nodes": {"x": {"type": "nonsense"}},
        "outputs": {"normal": {"from": "x.normal"}}})");
    EXPECT_FALSE(state.costs());
    settle();
    EXPECT_FALSE(state.costs());
}

// The costs of another file are never shown for this one.
TEST_F(Counted, ANewFileBeginsWithItsEstimate) {
    open(small_graph);
    settle();
    open(R"({"wrinkle": 1, "nodes": {
        "noise": {"type": "vec3_add", "in": {"a": {"from": "surface.position"},
                                         "b": {"from": "surface.position"}}}},
        "outputs": {"sum": {"from": "noise.vector"}}})");
    EXPECT_EQ(price_of("noise").cost.alu, 3U);
    settle();
    EXPECT_EQ(price_of("noise").cost.alu, 3U);
    EXPECT_FALSE(state.costs()->estimated);
}

// A module that would take the compilers many seconds is not counted; the same holds if there are
// no compilers.
TEST_F(Counted, AGraphThatCannotBeCountedKeepsItsEstimateAndSaysWhy) {
    std::string nodes = R"("n0": {"type": "gradient_noise", "in": {"octaves": 8}})",
                sum = "n0.height";
    for (int i = 1; i < 44; ++i) {
        const std::string n = std::to_string(i);
        nodes += R"(, "n)" + n + R"(": {"type": "gradient_noise", "in": {"octaves": 8, "scale": )" +
                 std::to_string(i + 1) + R"(}}, "s)" + n +
                 R"(": {"type": "gradient_add", "in": {"a": {"from": ")" + sum +
                 R"("}, "b": {"from": "n)" + n + R"(.height"}}})";
        sum = "s" + n + ".gradient";
    }
    open(R"({"wrinkle": 1, "nodes": {)" + nodes +
         R"(, "r": {"type": "resolve", "in": {"gradient": {"from": ")" + sum +
         R"("}}}}, "outputs": {"normal": {"from": "r.normal"}}})");
    ASSERT_GT(estimate(state.built).ops, max_counted);
    settle();
    ASSERT_TRUE(state.costs());
    EXPECT_TRUE(state.costs()->estimated);
    EXPECT_EQ(state.costs()->total.cost.alu, estimate(state.built).ops);
    const std::string text = in_full(state.costs()->total, *state.costs());
    EXPECT_NE(text.find("an estimate. It is too large"), std::string::npos) << text;
}

TEST_F(Counted, TheTooltipSaysAllOfIt) {
    open(small_graph);
    settle();
    const std::string text = in_full(state.costs()->total, *state.costs());
    EXPECT_NE(text.find(" numbers computed, of these 3 divisions and "), std::string::npos) << text;
    EXPECT_NE(text.find("every machine has 16"), std::string::npos) << text;
    EXPECT_EQ(in_full(price_of("noise"), *state.costs()).find("every machine"), std::string::npos);
    EXPECT_FALSE(has_tooltip());
    play("wheel status:cost 0");
    EXPECT_TRUE(has_tooltip());
}

}  // namespace
}  // namespace wrinkle::editor
