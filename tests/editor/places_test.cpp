// Tests of card positions: nodes without a stored position, the sample graphs, and Tidy.
#include "editor/model/document/files.h"
#include "editor/view/canvas/arrange.h"
#include "editor/view/canvas/layout.h"
#include "editor/view/look/draw.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

// Lists pairs of overlapping cards, except those that both have a stored position.
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

class Tidying : public Headless {
protected:
    void open_sample(const fs::path& graph) {
        open_file(state, graph);
        state.model = make_model(state.document(), graph.parent_path(), built_in_registry());
        state.view = {};
        state.layout_stale = true;
        update_layout(state);
    }
    void tidy() {
        const Tidied tidy = tidied(state);
        state.history = History(tidy.document);
        state.view = {};
        state.view.surface_at = tidy.borders.surface_at;
        state.view.outputs_at = tidy.borders.outputs_at;
        state.layout_stale = true;
        update_layout(state);
    }
};

TEST_F(Tidying, NoCardCoversAnother) {
    for (const fs::path& graph : all_graphs()) {
        open_sample(graph);
        tidy();
        EXPECT_EQ(overlaps(state.layout, Document()), "") << graph;
    }
}

// Samples the wire at 501 points, more finely than the editor.
bool runs_behind(const Wire& wire, const Card& card) {
    const Curve curve = wire_curve(wire.start, wire.end, 1);
    for (int i = 0; i <= 500; ++i) {
        const ImVec2 at = curve.at(static_cast<float>(i) / 500);
        if (at.x > card.at.x && at.x < card.at.x + card.size.x && at.y > card.at.y &&
            at.y < card.at.y + card.size.y)
            return true;
    }
    return false;
}

// Number of wires that run behind a card that is not at one of their ends.
size_t hidden_wires(const Layout& layout) {
    size_t hidden = 0;
    for (const Wire& wire : layout.wires)
        for (size_t i = 0; i < layout.cards.size(); ++i) {
            if (i == wire.from_card || i == wire.to_card) continue;
            if (!runs_behind(wire, layout.cards[i])) continue;
            ++hidden;
            std::printf("%s behind %s\n", wire.from.text().c_str(), layout.cards[i].id.c_str());
        }
    return hidden;
}

TEST_F(Tidying, HardlyAWireRunsBehindACard) {
    size_t wires = 0;
    for (const fs::path& graph : all_graphs()) {
        open_sample(graph);
        tidy();
        wires += state.layout.wires.size();
        // Materials have more wires than lanes between their columns of cards. They were at most 5
        // until noises had a seed: their cards are a row taller, and a column leaves fewer gaps.
        const fs::path folder = graph.parent_path().filename();
        const size_t most = folder == "materials" || folder == "rebuilt" ? 8 : 0;
        EXPECT_LE(hidden_wires(state.layout), most) << graph;
    }
    EXPECT_GT(wires, 500U);
}

TEST_F(Tidying, FramesGoWithTheirNodesAndUndoBringsAllBack) {
    open(small_graph);
    state.view.selected = {"softer", "normal"};
    play("key C\nkey Enter\ndrag node:noise node:number\nclick canvas+0,330");
    const Rectangle before = state.document().frames.begin()->rect;
    const ImVec2 output = state.layout.find("$output", Card::Kind::outputs)->at;
    play("key Ctrl+L\nassert status Tidy");
    const Rectangle after = state.document().frames.begin()->rect;
    EXPECT_NE(before, after);
    for (const char* id : {"softer", "normal"}) {
        const Card& card = *state.layout.find(id);
        EXPECT_GE(card.at.x, after.x) << id;
        EXPECT_GE(card.at.y, after.y + 30) << id << " is below the title";
        EXPECT_LE(card.at.x + card.size.x, after.x + after.width) << id;
        EXPECT_LE(card.at.y + card.size.y, after.y + after.height) << id;
    }
    const Card& normal = *state.layout.find("normal");
    EXPECT_GT(state.layout.find("$output", Card::Kind::outputs)->at.x, normal.at.x + normal.size.x);
    EXPECT_EQ(hidden_wires(state.layout), 0U);
    play("key Ctrl+Z");
    EXPECT_EQ(state.document().frames.begin()->rect, before);
    EXPECT_EQ(state.layout.find("$output", Card::Kind::outputs)->at.x, output.x);
    EXPECT_EQ(state.layout.find("$output", Card::Kind::outputs)->at.y, output.y);
}

}  // namespace
}  // namespace wrinkle::editor
