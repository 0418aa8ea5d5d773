// Tests of Save As into another folder: the graph refers to the same images and sub-graphs from
// there.
#include "editor/model/document/files.h"
#include "editor/model/document/moved_paths.h"
#include "graph/edit.h"
#include "graph/write.h"
#include "headless.h"

namespace wrinkle::editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* with_files = R"({
  "wrinkle": 1,
  "inputs": { "picture": { "type": "image", "default": "deep/in/b.png" } },
  "presets": { "Other": { "picture": "deep/a.png" } },
  "nodes": {
    "plain": { "type": "height_map", "in": { "image": "deep/a.png" } },
    "object": { "type": "height_map", "in": { "image": { "file": "./deep/../deep/a.png", "wrap": "clamp" } } },
    "outside": { "type": "height_map", "in": { "image": "textures/c.png" } },
    "absolute": { "type": "height_map", "in": { "image": "/nowhere/d.png" } },
    "part": { "type": "graph:deep/part.json" },
    "unknown": { "type": "no_such_node", "in": { "image": "deep/a.png" } },
    "number": { "type": "add" }
  }
})";

std::string image_of(const Document& document, const char* node) {
    const Input* input = document.find(node)->find("image");
    const json::Value file =
        input->value.is(json::Kind::object) ? input->value.find("file") : input->value;
    return std::string(file.as_string());
}

class SaveAs : public Headless {
protected:
    void open_with_files() {
        fs::create_directories(folder.path() / "deep" / "in");
        folder.write("deep/part.json", small_graph);
        open(with_files);
    }
};

TEST_F(SaveAs, InAFolderBelowFilesAreNamedFromThere) {
    open_with_files();
    ASSERT_TRUE(save_file_as(state, folder.path() / "deep" / "moved.json")) << state.status;
    const Document& now = state.document();
    EXPECT_EQ(image_of(now, "plain"), "a.png");
    EXPECT_EQ(image_of(now, "object"), "a.png");
    EXPECT_EQ(now.find("object")->find("image")->value.find("wrap").as_string(), "clamp");
    EXPECT_EQ(now.inputs.find("picture")->default_value.as_string(), "in/b.png");
    EXPECT_EQ(now.presets[0].values[0].value.as_string(), "a.png");
    EXPECT_EQ(image_of(now, "absolute"), "/nowhere/d.png");
    EXPECT_EQ(image_of(now, "unknown"), "deep/a.png") << "nobody knows that it is one";
    EXPECT_EQ(now.find("part")->type, "graph:part.json");
    EXPECT_EQ(text_of(state.path), write_document(now));
    EXPECT_EQ(text_of(file), with_files);
    frame();
    EXPECT_TRUE(state.type_of("part")) << "it is read from its new name";
    EXPECT_FALSE(state.dirty());
}

TEST_F(SaveAs, WhatIsNotBelowTheFolderIsNamedAllTheSameAndSaid) {
    open_with_files();
    fs::create_directories(folder.path() / "textures");
    fs::copy_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures/weave_normal.png",
                  folder.path() / "textures" / "c.png");
    ASSERT_TRUE(save_file_as(state, folder.path() / "deep" / "moved.json"));
    EXPECT_EQ(image_of(state.document(), "outside"), "../textures/c.png");
    EXPECT_NE(state.status.find("Saved moved.json. Not below its folder"), std::string::npos);
    EXPECT_NE(state.status.find("textures/c.png"), std::string::npos) << state.status;
    EXPECT_EQ(state.status.find("deep/a.png"), std::string::npos) << state.status;
    frame();
    bool said = false;
    for (const Diagnostic& problem : state.built.problems.list())
        said |= problem.node == "outside" && problem.message.find("root") != std::string::npos;
    EXPECT_TRUE(said) << to_text(state.built.problems);
}

// A graph that reads images and a sub-graph in folders below its own.
constexpr const char* far_reaching = R"({
  "wrinkle": 1,
  "nodes": {
    "own": { "type": "height_map", "in": { "image": "near/a.png" } },
    "plain": { "type": "height_map", "in": { "image": "textures/c.png" } },
    "part": { "type": "graph:parts/part.json" }
  },
  "outputs": { "height": { "from": "part.height" }, "other": { "from": "plain.height" } }
})";
constexpr const char* part_with_image = R"({
  "wrinkle": 1,
  "nodes": { "map": { "type": "height_map", "in": { "image": "../textures/d.png" } } },
  "outputs": { "height": { "from": "map.height" } }
})";

class TakenAlong : public SaveAs {
protected:
    TakenAlong() {
        for (const char* name : {"near", "textures", "parts"})
            fs::create_directories(folder.path() / name);
        for (const char* name : {"near/a.png", "textures/c.png", "textures/d.png"})
            fs::copy_file(fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures/weave_height.png",
                          folder.path() / name);
        folder.write("parts/part.json", part_with_image);
        open(far_reaching);
    }
    // Saves through the file browser, up to the dialog about the files.
    void save_in(const fs::path& there) {
        play("key Ctrl+Shift+S\nkey Ctrl+A\ntype " + (there / "moved.json").string() +
             "\nkey Enter");
    }
};

TEST_F(TakenAlong, FilesOutsideTheNewFolderAreCopied) {
    const TemporaryFolder other;
    save_in(other.path());
    play("click answer:copy\nassert clean\nassert errors 0");
    EXPECT_EQ(state.path.filename(), "moved.json");
    for (const char* name : {"near/a.png", "textures/c.png", "textures/d.png", "parts/part.json"})
        EXPECT_EQ(text_of(other.path() / name), text_of(folder.path() / name)) << name;
    EXPECT_EQ(program_output("check " + (other.path() / "moved.json").string()), "");
}

TEST_F(TakenAlong, BelowTheOldFolderOnlyWhatIsNotThereIsCopied) {
    const fs::path near = folder.path() / "near";
    save_in(near);
    play("click answer:copy\nassert clean\nassert errors 0");
    EXPECT_EQ(image_of(state.document(), "own"), "a.png");
    EXPECT_EQ(image_of(state.document(), "plain"), "textures/c.png");
    EXPECT_EQ(program_output("check " + (near / "moved.json").string()), "");
}

TEST_F(TakenAlong, AnotherFileOfTheSameNameIsKeptAndNothingIsWritten) {
    const TemporaryFolder other;
    fs::create_directories(other.path() / "textures");
    other.write("textures/c.png", "another");
    save_in(other.path());
    play("click answer:copy\nassert status there is another c.png");
    EXPECT_EQ(text_of(other.path() / "textures/c.png"), "another");
    EXPECT_FALSE(fs::exists(other.path() / "moved.json"));
    EXPECT_FALSE(fs::exists(other.path() / "near"));
    EXPECT_EQ(state.path, file);
}

TEST_F(TakenAlong, TheQuestionIsNotAskedWhereAllFilesAreInReach) {
    play("key Ctrl+Shift+S\nkey Ctrl+A\ntype " + (folder.path() / "beside.json").string() +
         "\nkey Enter\nassert no-target answer:copy\nassert clean\nassert errors 0");
    EXPECT_EQ(state.path.filename(), "beside.json");
}

TEST_F(TakenAlong, FilesMayStayWhereTheyAre) {
    const TemporaryFolder other;
    save_in(other.path());
    play("click answer:refer\nassert clean\nassert status Not below its folder");
    EXPECT_FALSE(fs::exists(other.path() / "textures"));
}

TEST_F(SaveAs, AndBackAgainGivesTheSameNames) {
    open_with_files();
    const fs::path other = folder.path() / "elsewhere";
    fs::create_directories(other);
    ASSERT_TRUE(save_file_as(state, other / "moved.json"));
    EXPECT_EQ(image_of(state.document(), "plain"), "../deep/a.png");
    EXPECT_EQ(state.document().find("part")->type, "graph:../deep/part.json");
    ASSERT_TRUE(save_file_as(state, folder.path() / "back.json"));
    EXPECT_EQ(image_of(state.document(), "plain"), "deep/a.png");
    EXPECT_EQ(image_of(state.document(), "outside"), "textures/c.png");
    EXPECT_EQ(state.document().find("part")->type, "graph:deep/part.json");
    EXPECT_EQ(state.status.find("Not below"), std::string::npos) << "absolute: " << state.status;
}

TEST_F(SaveAs, InTheSameFolderNothingChanges) {
    open_with_files();
    ASSERT_TRUE(save_file_as(state, folder.path() / "other.json"));
    EXPECT_EQ(text_of(state.path), with_files);
    EXPECT_FALSE(state.history.can_undo());
    ASSERT_TRUE(save_file_as(state, folder.path() / "deep" / ".." / "third.json"));
    EXPECT_EQ(text_of(state.path), with_files);
}

TEST_F(SaveAs, IsOneStepOfUndoAfterTheEditsBeforeIt) {
    open_with_files();
    state.commit("Move", move_node(state.document(), "number", 1, 2));
    const std::string edited = write_document(state.document());
    ASSERT_TRUE(save_file_as(state, folder.path() / "deep" / "moved.json"));
    play("assert clean\nkey Ctrl+Z\nassert dirty");
    EXPECT_EQ(write_document(state.document()), edited);
    play("key Ctrl+Shift+Z\nassert clean");
}

TEST_F(SaveAs, ThatFailsChangesNothing) {
    open_with_files();
    EXPECT_FALSE(save_file_as(state, folder.path() / "missing" / "moved.json"));
    EXPECT_EQ(state.path, file);
    EXPECT_FALSE(state.history.can_undo());
    EXPECT_EQ(image_of(state.document(), "plain"), "deep/a.png");
}

}  // namespace
}  // namespace wrinkle::editor
