// Tests of search results, and of the palette with keys and the mouse.
#include <chrono>
#include <set>

#include "editor/view/commands/commands.h"
#include "editor/view/panels/palette.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

int rank(const char* title, const char* id, const char* query, const char* doc = "") {
    const auto found = match(title, id, doc, query);
    return found ? found->rank : -1;
}

TEST(Search, RanksByWhereTheQueryStands) {
    EXPECT_EQ(rank("Scale", "gradient_scale", "scale"), 0);
    EXPECT_EQ(rank("Scale", "gradient_scale", "gradient_scale"), 0);
    EXPECT_EQ(rank("Scale", "gradient_scale", "sca"), 1);
    EXPECT_EQ(rank("Scale", "gradient_scale", "grad"), 2);
    EXPECT_EQ(rank("Limit slope", "clamp", "slo"), 3);
    EXPECT_EQ(rank("Limit slope", "gradient_clamp", "clamp"), 4);
    EXPECT_EQ(rank("Limit slope", "clamp", "lop"), 5);
    EXPECT_EQ(rank("Limit slope", "clamp", "amp"), 6);
    EXPECT_EQ(rank("Limit slope", "clamp", "lmsp"), 7);
    EXPECT_EQ(rank("Limit slope", "clamp", "steep", "Makes what is too steep less so"), 8);
    EXPECT_EQ(rank("Limit slope", "clamp", "st", "Makes what is too steep less so"), -1);
    EXPECT_EQ(rank("Limit slope", "clamp", "xyz"), -1);
    EXPECT_EQ(rank("Limit slope", "clamp", ""), 0);
}

TEST(Search, SaysWhichLettersMatch) {
    EXPECT_EQ(match("Limit slope", "", "", "slo")->letters, (std::vector<size_t>{6, 7, 8}));
    EXPECT_EQ(match("Limit slope", "", "", "lsp")->letters, (std::vector<size_t>{0, 6, 9}));
    EXPECT_TRUE(match("Limit slope", "clamp", "", "cla")->letters.empty());
}

TEST_F(Headless, ThreeLettersPutEveryNodeOnTop) {
    open(small_graph);
    size_t ties = 0;
    std::string tied;
    for (const NodeType& type : built_in_registry().list()) {
        const std::string query = lower_case(type.title).substr(0, 3);
        size_t before = 0;
        bool found = false;
        state.palette.query = query;
        for (const PaletteRow& row : palette_rows(state)) {
            found = row.type == &type;
            if (found) break;
            ++before;
            // Only a title that begins with the same letters may be ranked before it.
            EXPECT_TRUE(lower_case(row.title).starts_with(query))
                << "'" << query << "' finds " << row.title << " before " << type.title;
        }
        EXPECT_TRUE(found) << type.title;
        if (before > 0) tied += "  " + query + ": " + type.title + "\n";
        ties += before > 0;
    }
    RecordProperty("ties", static_cast<int>(ties));
    std::printf("%zu of %zu titles share their first three letters with another:\n%s", ties,
                built_in_registry().list().size(), tied.c_str());
}

TEST_F(Headless, TheWholeTitlePutsANodeFirst) {
    open(small_graph);
    for (const NodeType& type : built_in_registry().list()) {
        state.palette.query = type.title;
        EXPECT_EQ(palette_rows(state).front().title, type.title);
    }
}

TEST_F(Headless, NamesInOtherProgramsFindNodes) {
    open(small_graph);
    const std::pair<const char*, const char*> searches[] = {
        {"map range", "remap"},         {"lerp", "mix"},         {"noise tex", "fbm"},
        {"xyz", "separate_vec3"},       {"one minus", "invert"}, {"Gradient Map", "ramp"},
        {"normal comb", "gradient_add"}};
    for (const auto& [query, type] : searches) {
        state.palette.query = query;
        const std::vector<PaletteRow> rows = palette_rows(state);
        const auto found = std::ranges::find_if(rows, [&type = type](const PaletteRow& row) {
            return row.type && row.type->id == type;
        });
        ASSERT_TRUE(found != rows.end()) << query;
        EXPECT_LT(found - rows.begin(), 2) << query;
        EXPECT_TRUE(found->doc.ends_with(" elsewhere")) << found->doc;
    }
    for (const OtherName& other : other_names()) {
        EXPECT_TRUE(built_in_registry().find(other.type)) << other.type;
        EXPECT_EQ(other_name(other.type, lower_case(other.name)), other.name);
    }
    EXPECT_EQ(other_name("mix", "le"), "");
    EXPECT_EQ(other_name("add", "lerp"), "");
}

// Searches 500 types; the time is printed, not checked.
TEST(Search, OfManyTypesIsQuick) {
    std::vector<std::string> titles;
    for (int i = 0; i < 500; ++i)
        titles.push_back("Some layered bump number " + std::to_string(i));
    const auto start = std::chrono::steady_clock::now();
    size_t found = 0;
    for (const std::string& title : titles)
        found +=
            match(title, "some_layered_bump", "A doc line of usual length, with words.", "number 4")
                .has_value();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(found, 176U);  // all numbers that contain a 4
    std::printf("500 types searched in %.3f ms\n", time.count());
}

TEST_F(Headless, WhatWasUsedLatelyComesFirst) {
    open(small_graph);
    EXPECT_NE(palette_rows(state).front().type->id, "weave");
    play("key Space\ntype weave\nkey Enter\nassert node weave");
    state.palette = {};
    EXPECT_EQ(palette_rows(state).front().type->id, "weave");
    play("key Ctrl+P\ntype tidy\nkey Enter");
    state.palette.list = Palette::List::commands;
    EXPECT_EQ(palette_rows(state).front().title, "Tidy");
}

TEST_F(Headless, FavoritesComeFirstAndAreStored) {
    open(small_graph);
    play("click canvas+0,300\nkey Space\ntype ridged\nkey Ctrl+D\nkey Escape");
    EXPECT_EQ(state.keeping.settings.favorites, std::vector<std::string>{"ridged"});
    play("key Space");
    EXPECT_EQ(palette_rows(state).front().type->id, "ridged");
    EXPECT_TRUE(palette_rows(state).front().favorite);
    play("click palette:ridged:favorite");
    EXPECT_TRUE(state.keeping.settings.favorites.empty());
    EXPECT_NE(palette_rows(state).front().type->id, "ridged");
    EXPECT_TRUE(state.palette.open);
}

TEST_F(Headless, AWireFiltersAndTabWidens) {
    open(small_graph);
    play(R"(
        drag out:normal.normal canvas+100,300
        type cosine
        key Enter
        assert nodes 4
        assert no-target palette:cosine
        key Tab
        assert target palette:cosine
        key Tab
        assert no-target palette:cosine
        key Escape
        assert nodes 4)");
}

TEST_F(Headless, ThePaletteIsChosenFromByKeysAndByTheMouse) {
    open(small_graph);
    play("key Space\ntype gradient\nassert target palette:gradient_noise\nkey Down\nkey Down");
    EXPECT_EQ(state.palette.chosen, 2);
    play("key Up\nkey Enter\nassert nodes 5\nclick canvas+0,300");
    play("key Space\nwheel palette:tangent_normal_map -2");
    EXPECT_GT(state.palette.first, 0);
    const auto rows = palette_rows(state);
    play("click " + rows[static_cast<size_t>(state.palette.first) + 3].target + "\nassert nodes 6");
}

TEST_F(Headless, ACommandThatCannotBeRunSaysWhy) {
    open(small_graph);
    play(R"(
        key Ctrl+P
        type undo
        assert target palette:undo
        key Enter
        assert status Nothing has been done yet.
        key Escape
        assert clean)");
}

TEST_F(Headless, TheHistoryReturnsToAnyStep) {
    open(small_graph);
    play("key Ctrl+H");
    EXPECT_FALSE(state.palette.open);
    const std::string before = canonical_text(state.document());
    play(R"(
        key Space
        type weave
        key Enter
        click canvas+0,300
        key Space
        type cosine
        key Enter
        assert nodes 6)");
    const std::string after = canonical_text(state.document());
    play("key Ctrl+H");
    EXPECT_EQ(palette_rows(state)[0].key, "now");
    play("key Down\nkey Down\nkey Enter\nassert nodes 4\nassert status Back at the start");
    EXPECT_EQ(canonical_text(state.document()), before);
    play("key Ctrl+H");
    EXPECT_EQ(state.palette.chosen, 2);
    EXPECT_EQ(palette_rows(state)[0].doc, "undone");
    play("click palette:step1\nassert nodes 5\nassert status Back at: Add Weave");
    play("key Ctrl+H\ntype cosine\nkey Enter\nassert nodes 6");
    EXPECT_EQ(canonical_text(state.document()), after);
}

const char* const scaled_graph = R"({
  "wrinkle": 1,
  "inputs": { "bump": { "type": "gradient" } },
  "nodes": { "half": { "type": "gradient_scale", "in": { "gradient": { "from": "input.bump" }, "amount": 0.5 } } },
  "outputs": { "bump": { "from": "half.gradient" } }
}
)";

TEST_F(Headless, AGraphOfTheFolderBecomesANode) {
    std::filesystem::create_directories(folder.path() / "parts");
    folder.write("parts/half-bump.json", scaled_graph);
    open(small_graph);
    play("key Space\ntype half\nkey Enter\nassert nodes 5\nassert errors 0");
    const Node* node = state.document().find("half_bump");
    ASSERT_TRUE(node);
    EXPECT_EQ(node->type, "graph:parts/half-bump.json");
    play(R"(
        drag out:softer.gradient canvas+0,330
        type half-bump
        key Enter
        assert nodes 6
        assert wire softer.gradient half_bump2.bump
        assert errors 0)");
}

TEST_F(Headless, AGraphThatCannotBeASubgraphSaysWhy) {
    open(small_graph);
    folder.write("broken.json", R"({ "wrinkle": 1, "nodes": 5)");
    const std::string user = R"({ "wrinkle": 1, "nodes": { "a": { "type": "graph:)" +
                             file.filename().string() + R"(" } } })";
    folder.write("user.json", user);
    play("key Space\ntype broken\nkey Enter\nassert nodes 4\nassert status broken.json: ");
    play("key Space\ntype user\nkey Enter\nassert nodes 4\nassert status contains itself");
    play("key Space");
    for (const PaletteRow& row : palette_rows(state))
        EXPECT_NE(row.graph, file.filename().string());
}

TEST_F(Headless, AGraphWithoutAPortForTheWireSaysSo) {
    folder.write("other.json", small_graph);
    open(small_graph);
    play(R"(
        drag out:softer.gradient canvas+0,330
        type other
        key Enter
        assert nodes 5
        assert status other.json has no port for gradient)");
}

TEST_F(Headless, EveryCommandIsInThePaletteAndInAMenu) {
    open(small_graph);
    state.palette.list = Palette::List::commands;
    const auto rows = palette_rows(state);
    for (const Command& command : commands()) {
        const auto is_it = [&](const PaletteRow& row) { return row.command == &command; };
        EXPECT_EQ(std::count_if(rows.begin(), rows.end(), is_it), 1) << command.id;
        state.palette.query = command.title;
        EXPECT_EQ(palette_rows(state).front().title, command.title);
        state.palette.query.clear();
    }
    std::set<std::string> menus;
    for (const Command& command : commands())
        menus.insert(std::string(command.menu));
    for (const std::string& menu : menus) {
        play("click menu:" + menu);
        for (const Command& command : commands())
            EXPECT_TRUE(command.menu != menu ||
                        state.targets.find("menu:" + std::string(command.id)))
                << command.id;
        play("key Escape\nwait");
    }
}

}  // namespace
}  // namespace wrinkle::editor
