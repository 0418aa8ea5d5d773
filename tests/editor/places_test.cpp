// Where cards stand that nobody has put anywhere, and those of the graphs that come along.
#include "editor/canvas/layout.h"
#include "editor/document/files.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

// Pairs of cards that lie over each other, but those that somebody put there.
std::string overlaps(const Layout& layout, const Document& document) {
    std::string found;
    const auto placed = [&](const Card& card) { return document.positions.find(card.id); };
    for (size_t i = 0; i < layout.cards.size(); ++i)
        for (size_t k = i + 1; k < layout.cards.size(); ++k) {
            const Card &a = layout.cards[i], &b = layout.cards[k];
            if (placed(a) && placed(b)) continue;
            if (a.at.x < b.at.x + b.size.x && b.at.x < a.at.x + a.size.x &&
                a.at.y < b.at.y + b.size.y && b.at.y < a.at.y + a.size.y)
                found += " " + a.id + "/" + b.id;
        }
    return found;
}

std::vector<fs::path> all_graphs() {
    std::vector<fs::path> graphs;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(WRINKLE_SOURCE_DIR) / "graphs")) {
        const fs::path& path = entry.path();
        const bool test = path.stem().extension() == ".test";
        if (path.extension() == ".json" && !test) graphs.push_back(path);
    }
    return graphs;
}

Document without_places(Document document, size_t keep_each) {
    std::vector<Position> kept;
    for (size_t i = 0; i < document.positions.size(); ++i)
        if (keep_each > 0 && i % keep_each == 0) kept.push_back(document.positions[i]);
    document.positions = Table<Position>(std::move(kept));
    return document;
}

TEST_F(Headless, NodesWithoutPlacesDoNotOverlap) {
    size_t nodes = 0;
    for (const fs::path& graph : all_graphs()) {
        open_file(state, graph);
        const Document document = state.document();
        state.model = make_model(document, graph.parent_path(), built_in_registry());
        for (const size_t keep_each : {0, 2, 3}) {
            state.history = History(without_places(document, keep_each));
            state.view = {};
            state.layout_stale = true;
            update_layout(state);
            nodes += document.nodes.size();
            EXPECT_EQ(overlaps(state.layout, state.document()), "")
                << graph << " with each " << keep_each << " kept";
        }
    }
    EXPECT_GT(nodes, 1000U);
}

TEST_F(Headless, MovingOneCardLeavesTheOthersWhereTheyAre) {
    open(R"({"wrinkle": 1, "nodes": {"a": {"type": "sine"}, "b": {"type": "sine"},
        "c": {"type": "sine", "in": {"angle": {"from": "a.result"}}}}})");
    const ImVec2 a = state.layout.find("a")->at, c = state.layout.find("c")->at;
    play("drag node:b node:b+0,160\nassert dirty");
    EXPECT_EQ(state.layout.find("a")->at.y, a.y);
    EXPECT_EQ(state.layout.find("c")->at.x, c.x);
    EXPECT_GT(state.layout.find("b")->at.y, a.y + 100);
    play("key Ctrl+Z\nassert clean");
}

TEST_F(Headless, TheGraphsThatComeWithItDoNotOverlap) {
    for (const fs::path& graph : all_graphs()) {
        open_file(state, graph);
        frame();
        EXPECT_EQ(overlaps(state.layout, Document()), "") << graph;
    }
}

TEST_F(Headless, TidiedGraphsDoNotOverlap) {
    for (const fs::path& graph : all_graphs()) {
        open_file(state, graph);
        state.model = make_model(state.document(), graph.parent_path(), built_in_registry());
        state.layout_stale = true;
        update_layout(state);
        const Document tidy = tidied(state);
        state.history = History(tidy);
        state.view = {};
        state.layout_stale = true;
        update_layout(state);
        EXPECT_EQ(overlaps(state.layout, Document()), "") << graph;
    }
}

}  // namespace
}  // namespace wrinkle::editor
