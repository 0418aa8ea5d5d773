// Tests of the files that the editor reads and writes: graphs and the images near them.
#include <sys/stat.h>

#include "editor/view/panels/panels.h"
#include "graph/edit.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

TEST_F(Headless, SavesWhatIsShownAndOnlyTheEditedLine) {
    open(small_graph);
    play("key Ctrl+S");
    EXPECT_EQ(text_of(file), small_graph) << "an untouched graph keeps its bytes";
    play(R"(
        double field:softer.amount
        type 0.25
        key Enter
        assert dirty
        click menu:File
        click menu:save
        assert clean)");
    std::string expected = small_graph;
    expected.replace(expected.find("\"amount\": 0.6"), 13, "\"amount\": 0.25");
    EXPECT_NE(text_of(file).find("\"amount\": 0.25"), std::string::npos);
    EXPECT_EQ(text_of(file), expected);
    play("key Ctrl+Z\nassert dirty\nkey Ctrl+S");
    EXPECT_EQ(text_of(file), small_graph);
}

TEST_F(Headless, EditsAndUndoPreserveInputsAndPresets) {
    const std::string exposed = R"("name": "Small",
  "inputs": {
    "wear": {
      "type": "float",
      "default": 0.50,
      "slider": [0, 1.0],
      "label": "Wear",
      "group": "Wear/Edges"
    }
  },
  "presets": {
    "Old": { "wear": 0.80 }
  })";
    std::string graph = small_graph;
    graph.replace(graph.find("\"name\": \"Small\""), 15, exposed);
    open(graph);
    play("double field:softer.amount\ntype 0.25\nkey Enter\nkey Ctrl+S");
    std::string expected = graph;
    expected.replace(expected.find("\"amount\": 0.6"), 13, "\"amount\": 0.25");
    EXPECT_EQ(text_of(file), expected);
    Preset old = state.document().presets[0];
    old.values[0].value = json::Value::number(1);
    state.commit("Preset", set_preset(state.document(), old));
    play("assert dirty\nkey Ctrl+Z\nkey Ctrl+Z\nkey Ctrl+S");
    EXPECT_EQ(text_of(file), graph);
}

// An option that an input of the graph sets has a wire, which the canvas does not draw.
TEST_F(Headless, EditsPreserveWiresOfOptions) {
    std::string graph = small_graph;
    graph.replace(graph.find("\"scale\": 3.0"), 12, R"("octaves": { "from": "input.n" })");
    graph.replace(graph.find("\"nodes\""), 7, R"("inputs": {
    "n": { "type": "count", "default": 2 }
  },
  "nodes")");
    open(graph);
    play("double field:softer.amount\ntype 0.25\nkey Enter\nkey Ctrl+S");
    std::string expected = graph;
    expected.replace(expected.find("\"amount\": 0.6"), 13, "\"amount\": 0.25");
    EXPECT_EQ(text_of(file), expected);
    EXPECT_FALSE(state.built.problems.has_errors()) << to_text(state.built.problems);
    play("key Ctrl+Z\nkey Ctrl+S");
    EXPECT_EQ(text_of(file), graph);
}

TEST_F(Headless, AFileThatWasNotReadWholeIsNotOverwritten) {
    const std::string broken = std::string(small_graph).substr(0, 300);
    open(broken);
    play("key Ctrl+S\nassert status Not saved");
    EXPECT_EQ(text_of(file), broken);
}

TEST_F(Headless, AFileThatIsNoGraphIsNotOverwritten) {
    open("[1, 2, 3]");
    play("key Space\ntype smoothstep\nkey Enter\nkey Ctrl+S\nassert status Not saved");
    EXPECT_EQ(text_of(file), "[1, 2, 3]");
}

TEST_F(Headless, ImageFilesAreThoseNearTheGraph) {
    namespace fs = std::filesystem;
    fs::create_directories(folder.path() / "a" / "deep");
    fs::create_directories(folder.path() / "b");
    for (const char* name : {"z.png", "a/deep/d.exr", "a/c.jpg", "b/b.png", "b/notes.txt"})
        folder.write(name, "x");
    fs::create_directory_symlink(folder.path(), folder.path() / "a" / "again");
    using Names = std::vector<std::string>;
    EXPECT_EQ(image_files(folder.path()), (Names{"a/c.jpg", "a/deep/d.exr", "b/b.png", "z.png"}));
    EXPECT_EQ(image_files(folder.path(), 3), (Names{"a/c.jpg", "b/b.png", "z.png"}));
    EXPECT_EQ(image_files(folder.path(), 9, 3), (Names{"z.png"}));
    EXPECT_EQ(image_files(folder.path() / "none"), Names{});
}

TEST_F(Headless, GraphFilesAreNeitherTestsNorPresetsNorHidden) {
    namespace fs = std::filesystem;
    fs::create_directories(folder.path() / "parts");
    fs::create_directories(folder.path() / ".wrinkle");
    for (const char* name : {"a.json", "parts/b.json", "a.test.json", "a.preset.json",
                             ".wrinkle/c.json", ".hidden.json", "a.txt"})
        folder.write(name, small_graph);
    folder.write("package.json", R"({ "name": "none" })");
    ASSERT_EQ(mkfifo((folder.path() / "pipe.json").c_str(), 0600), 0);
    EXPECT_EQ(graph_files(folder.path()), (std::vector<std::string>{"a.json", "parts/b.json"}));
}

// The list is read once when it opens: the folder is not walked on every frame.
TEST_F(Headless, ImagesAreListedOnceWhenTheListOpens) {
    std::string graph = small_graph;
    graph.replace(graph.find("\"number\": {"), 11,
                  R"("map": { "type": "height_map", "in": { "image": "x.png" } }, "number": {)");
    folder.write("one.png", "x");
    open(graph);
    play("click field:map.image\nassert target choice:one.png");
    folder.write("two.png", "x");
    frame();
    EXPECT_TRUE(state.targets.find("choice:one.png"));
    EXPECT_FALSE(state.targets.find("choice:two.png"));
    play("key Escape\nclick field:map.image\nassert target choice:two.png");
}

TEST_F(Headless, AMissingPluginIsShownKeptAndReported) {
    std::string graph = small_graph;
    graph.replace(graph.find("\"type\": \"add\""), 13, "\"type\": \"acme\"");
    open(graph);
    play(R"(
        assert node number
        assert target node:number
        assert target problem:1
        click problem:1
        drag node:softer node:softer+40,40
        key Ctrl+S)");
    EXPECT_NE(text_of(file).find("\"type\": \"acme\""), std::string::npos);
}

}  // namespace
}  // namespace wrinkle::editor
