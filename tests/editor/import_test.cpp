// Tests of a folder of textures dropped on the window: it becomes the graph that `wrinkle import`
// writes, as one step of a new graph.
#include "editor/model/document/texture_import.h"

#include <fstream>

#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

class ImportedFolder : public Headless {
protected:
    ImportedFolder() {
        fs::create_directory(bricks);
        const std::pair<const char*, const char*> files[] = {
            {"weave_normal.png", "brick_Normal.png"}, {"bricks_height.png", "brick_Height.png"}};
        for (const auto& [from, to] : files)
            fs::copy_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures" / from, bricks / to);
    }
    fs::path bricks = folder.path() / "bricks";
};

TEST_F(ImportedFolder, IsTheGraphOfTheProgram) {
    open("{\n  \"wrinkle\": 1\n}\n");
    program_output("import " + bricks.string() + " -o " + (bricks / "g.json").string());
    play(R"(
        drop bricks canvas
        finish
        assert status Made a graph of bricks.
        assert nodes 4
        assert errors 0)");
    EXPECT_EQ(canonical_text(state.document()), text_of(bricks / "g.json"));
    EXPECT_EQ(state.path, "");
    EXPECT_EQ(state.folder(), fs::canonical(bricks));
    EXPECT_EQ(text_of(file), "{\n  \"wrinkle\": 1\n}\n");
    play("key Ctrl+Z\nassert nodes 0\nassert clean\nkey Ctrl+Shift+Z\nassert nodes 4");
}

TEST_F(ImportedFolder, WaitsForTheDecisionOnUnsavedWork) {
    open(small_graph);
    play(R"(
        click node:number
        key Delete
        drop bricks/ canvas
        finish
        assert target answer:discard
        click answer:cancel
        assert nodes 3
        drop bricks canvas
        finish
        click answer:discard
        assert nodes 4)");
    EXPECT_EQ(state.document().name, "brick");
}

// A question that is open when the task ends is answered first.
TEST_F(ImportedFolder, DoesNotReplaceAnOpenQuestion) {
    open(small_graph);
    play("click node:number\nkey Delete\nkey Ctrl+N\nassert target answer:discard");
    ASSERT_TRUE(import_folder(state, bricks));
    while (!state.tasks.running->ended())
        std::this_thread::yield();
    play("wait\nassert nodes 3");
    EXPECT_EQ(state.question.then.kind, PendingAction::Kind::new_graph);
    play("click answer:cancel\nfinish\nassert nodes 3");
    EXPECT_EQ(state.question.then.kind, PendingAction::Kind::import);
    play("click answer:discard\nassert nodes 4");
    EXPECT_TRUE(state.document().find("height_map"));
}

TEST_F(ImportedFolder, ThatHoldsNoSetChangesNothing) {
    open(small_graph);
    fs::create_directory(folder.path() / "empty");
    play("drop empty canvas\nfinish\nassert nodes 4\nassert clean\nassert target task:again");
    EXPECT_TRUE(state.tasks.failed.starts_with("No graph was made of empty. empty: holds no image"))
        << state.tasks.failed;
    EXPECT_EQ(state.path, file);
    fs::create_directory(folder.path() / "out");
    fs::create_symlink(bricks / "brick_Normal.png", folder.path() / "out/a_normal.png");
    play("drop out canvas\nfinish\nassert nodes 4");
    EXPECT_TRUE(state.tasks.failed.find("a_normal.png leads out of the folder") !=
                std::string::npos)
        << state.tasks.failed;
    fs::create_directory(folder.path() / "broken");
    folder.write("broken/a_color.png", "no image");
    play("drop broken canvas\nfinish\nassert nodes 4");
    EXPECT_TRUE(state.tasks.failed.find("a_color.png' is not an image") != std::string::npos)
        << state.tasks.failed;
}

TEST_F(ImportedFolder, ShowsItsWarningsAmongTheProblems) {
    fs::copy_file(bricks / "brick_Height.png", bricks / "brick_spec.png");
    open(small_graph);
    play("drop bricks canvas\nfinish\nassert nodes 4");
    ASSERT_EQ(state.tasks.warnings.list().size(), 1U);
    EXPECT_EQ(state.tasks.warnings.list()[0].message,
              "is left out: the material has no channel for 'spec'");
    EXPECT_EQ(state.tasks.warnings_of, state.path);
}

}  // namespace
}  // namespace wrinkle::editor
