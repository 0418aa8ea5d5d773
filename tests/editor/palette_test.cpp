// Tests of search results, and of the palette with keys and the mouse.
#include <chrono>
#include <set>

#include "editor/view/commands/commands.h"
#include "editor/view/panels/palette.h"
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
    state.palette.commands = true;
    EXPECT_EQ(palette_rows(state).front().title, "Tidy");
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

TEST_F(Headless, EveryCommandIsInThePaletteAndInAMenu) {
    open(small_graph);
    state.palette.commands = true;
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
