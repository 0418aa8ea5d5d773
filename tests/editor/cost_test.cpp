// What the material costs, per card.
#include "editor/document/cost.h"

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
