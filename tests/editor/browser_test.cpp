// Tests of the file browser and the start page.
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>

#include "editor/view/commands/commands.h"
#include "editor/view/panels/browser.h"
#include "editor/view/panels/panels.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;
using Purpose = Browser::Purpose;

std::string names(const Listing& listing) {
    std::string text;
    for (const Entry& entry : listing.entries)
        text += entry.name + (entry.folder ? "/ " : " ");
    return text;
}

TEST(Listing, HasFoldersFirstAndNamesAsPeopleCount) {
    const TemporaryFolder folder;
    for (const char* name : {"wood10.png", "wood2.png", "Bark.PNG", "notes.txt", ".hidden.png"})
        folder.write(name, "x");
    fs::create_directory(folder.path() / "zebra");
    fs::create_directory(folder.path() / ".git");
    const std::string png = ".png";
    EXPECT_EQ(names(list_folder(folder.path(), {&png, 1})),
              "zebra/ Bark.PNG wood2.png wood10.png ");
    EXPECT_EQ(list_folder(folder.path(), {}).entries.size(), 5U);
    EXPECT_TRUE(list_folder(folder.path(), {}).error_text.empty());
}

TEST(Listing, SaysWhyAFolderCannotBeRead) {
    const TemporaryFolder folder;
    EXPECT_NE(list_folder(folder.path() / "none", {}).error_text, "");
    EXPECT_NE(list_folder(folder.write("file", "x"), {}).error_text, "");
    if (geteuid() == 0) return;  // root can read every folder
    fs::create_directory(folder.path() / "closed");
    chmod((folder.path() / "closed").c_str(), 0);
    EXPECT_NE(list_folder(folder.path() / "closed", {}).error_text.find("closed"),
              std::string::npos);
}

TEST(Listing, ComparesNames) {
    EXPECT_TRUE(name_before("a2", "a10"));
    EXPECT_FALSE(name_before("a10", "a2"));
    EXPECT_TRUE(name_before("a", "a1"));
    EXPECT_TRUE(name_before("A", "b"));
    EXPECT_TRUE(name_before("a007", "a8"));
    EXPECT_FALSE(name_before("x", "x"));
    std::vector<std::string> all = {"b", "a10b", "a2", "a02", "", "0", "00", "a", "A"};
    std::sort(all.begin(), all.end(), name_before);  // needs a strict weak ordering to end
    EXPECT_EQ(all.front(), "");
}

TEST_F(Headless, AFileIsFoundByTypingAndOpened) {
    fs::create_directory(folder.path() / "inner");
    folder.write("inner/other.json", small_graph);
    folder.write("inner/another.json", "{ \"wrinkle\": 1 }");
    open(R"({ "wrinkle": 1 })");
    browse(state, Purpose::open_graph, file);
    play(R"(
        assert target file:inner
        type inn
        key Enter
        assert target file:other.json
        type oth
        key Enter
        assert nodes 4)");
    EXPECT_EQ(state.browser.purpose, Purpose::none);
    EXPECT_EQ(state.path.filename(), "other.json");
}

TEST_F(Headless, TheBrowserGoesUpByBackspaceAndByPath) {
    fs::create_directory(folder.path() / "inner");
    open(R"({ "wrinkle": 1 })");
    browse(state, Purpose::open_graph, folder.path() / "inner/x.json");
    play("key Backspace\nassert target file:inner");
    play("click file:inner\nwait");
    EXPECT_EQ(state.browser.folder.filename(), "inner");
    play("type ..\nkey Enter\nassert target file:graph.json\ntype /\nkey Enter\nwait");
    EXPECT_EQ(state.browser.folder, fs::path("/"));
    play("key Escape\nwait");
    EXPECT_EQ(state.browser.purpose, Purpose::none);
}

TEST_F(Headless, TheTextIsExportedUnderAName) {
    open(small_graph);
    play("key Ctrl+E\nkey Ctrl+A\ntype made\nkey Enter\nfinish\nassert status made.glsl");
    EXPECT_EQ(text_of(folder.path() / "made.glsl"), program_output("compile " + file.string()));
}

TEST_F(Headless, TheTextHasTheSuffixOfItsTarget) {
    for (const char* name : {"old.hlsl", "old.wgsl", "old.shader", "old.frag.spv", "old.png"})
        folder.write(name, "x");
    open(small_graph);
    state.code.options.target = "wgsl";
    play("key Ctrl+E\nwait");
    EXPECT_EQ(names(state.browser.listing), "old.frag.spv old.hlsl old.shader old.wgsl ");
    play("key Ctrl+A\ntype made\nkey Enter\nfinish\nassert status made.wgsl");
    state.code.options.target = "spirv";
    play("key Ctrl+E\nkey Ctrl+A\ntype made\nkey Enter\nfinish");
    EXPECT_TRUE(fs::exists(folder.path() / "made.frag.spv"));
}

TEST_F(Headless, APictureFromElsewhereIsBrowsedForAndCopied) {
    open(R"({ "wrinkle": 1, "nodes": { "map": { "type": "tangent_normal_map" } } })");
    const TemporaryFolder elsewhere;
    fs::copy_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures/weave_normal.png",
                  elsewhere.path() / "weave_normal.png");
    play("click field:map.image\nclick choice:browse\nwait\ntype " + elsewhere.path().string() +
         "\nkey Enter\nassert target file:weave_normal.png\nclick file:weave_normal.png\n"
         "click browser:take\nassert clean\nclick copy:yes\n"
         "assert value map.image \"weave_normal.png\"");
    EXPECT_TRUE(fs::exists(folder.path() / "weave_normal.png"));
}

TEST_F(Headless, OfAHugeFolderOnlyWhatIsSeenIsDrawn) {
    for (int i = 0; i < 3000; ++i)
        folder.write("graph" + std::to_string(i) + ".json", "");
    open(R"({ "wrinkle": 1 })");
    browse(state, Purpose::open_graph, file);
    frame();
    frame();
    size_t drawn = 0;
    for (const auto& [name, rect] : state.targets.all())
        drawn += name.starts_with("file:");
    EXPECT_GT(drawn, 5U);
    EXPECT_LT(drawn, 60U);
    EXPECT_EQ(state.browser.shown.size(), 3001U);
}

TEST(Samples, AreListedByName) {
    for (const char* folder : {"graphs", "graphs/materials"}) {
        const auto samples = list_samples(fs::path(WRINKLE_SOURCE_DIR) / folder);
        EXPECT_GE(samples.size(), 20U);
        for (const Sample& sample : samples) {
            EXPECT_FALSE(sample.name.empty());
            EXPECT_GT(sample.nodes, 0U);
            EXPECT_TRUE(fs::exists(sample.image)) << sample.image;
        }
    }
    EXPECT_TRUE(list_samples("/no/such/folder").empty());
}

TEST_F(Headless, TheStartPageOpensASampleInOneClick) {
    state.start.read = true;  // use the samples of this test
    state.start.techniques = list_samples(fs::path(WRINKLE_SOURCE_DIR) / "graphs");
    state.path.clear();
    frame();
    frame();
    ASSERT_TRUE(is_at_start(state));
    play("assert target start:drop\nclick sample:" +
         state.start.techniques.front().file.stem().string() + "\nassert no-target start:drop");
    EXPECT_FALSE(state.document().nodes.empty());
}

TEST_F(Headless, TheStartPageTakesTwoPictures) {
    state.start.read = true;
    state.path = "";
    frame();
    frame();
    const std::string from = std::string(WRINKLE_SOURCE_DIR) + "/graphs/textures/";
    fs::current_path(WRINKLE_SOURCE_DIR);  // folder of a graph without a file
    play("drop " + from + "rivets_normal.png " + from +
         "weave_normal.png start:drop\n"
         "assert nodes 4\nassert wire weave_normal.gradient gradient_add.b");
    EXPECT_FALSE(is_at_start(state));
}

TEST_F(Headless, TheStartPageLeavesForAnEmptyGraph) {
    state.start.read = true;
    state.path.clear();
    frame();
    frame();
    play("click start:new\nassert no-target start:drop\nassert nodes 0");
}

}  // namespace
}  // namespace wrinkle::editor
