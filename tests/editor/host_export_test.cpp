// Tests of exports to hosts from the editor: the files equal those of `wrinkle export`.
#include "editor/model/hosts/host_export.h"
#include "baking.h"
#include "editor/model/document/files.h"
#include "editor/model/hosts/repeated_exports.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

using EditorHostExport = Baking;

TEST_F(EditorHostExport, TheDialogWritesTheFilesOfTheProgram) {
    open(rock);
    play(
        "key Ctrl+Shift+E\nassert target host:start\nclick host:to:gltf\n"
        "click host:mesh\nclick host:mesh:torus\nclick host:size\nclick host:size:256\n"
        "click host:start\nassert no-target host:start\nfinish\n"
        "assert status Wrote 2 files for glTF 2.0 into graph_gltf");
    program_output("export " + file.string() + " --to gltf --mesh torus --size 256 -o " +
                   (folder.path() / "theirs").string());
    expect_same("graph_gltf/graph.glb", "theirs/graph.glb");
    expect_same("graph_gltf/README.txt", "theirs/README.txt");
}

TEST_F(EditorHostExport, AnExportIsRepeatedAtEverySave) {
    open(rock);
    const fs::path into = folder.path() / "graph_gltf";
    play(
        "assert no-target status:exported\nkey Ctrl+Shift+E\nclick host:to:gltf\n"
        "click host:size\nclick host:size:256\nclick host:repeat\nclick host:start\nfinish");
    fs::remove_all(into);
    play("key Space\ntype weave\nkey Enter\nfinish");
    EXPECT_FALSE(fs::exists(into));
    play("key Ctrl+S\nwait 2\nfinish\nassert target status:exported");
    EXPECT_TRUE(fs::exists(into / "graph.glb"));
    EXPECT_EQ(state_of_repeats(state), RepeatState::written);
    EXPECT_TRUE(words_on_repeats(state).starts_with("Exported ")) << words_on_repeats(state);

    fs::remove_all(into);
    folder.write("graph_gltf", "a file in place of the folder");
    play("key Ctrl+Z\nkey Ctrl+S\nwait 2\nfinish");
    EXPECT_EQ(words_on_repeats(state), "Not exported");
    EXPECT_NE(state.tasks.failed.find("No file was exported. "), std::string::npos);

    fs::remove_all(into);
    play("key Ctrl+Shift+Z\nkey Ctrl+S\nwait 2\nfinish");
    EXPECT_TRUE(words_on_repeats(state).starts_with("Exported ")) << words_on_repeats(state);

    play("key Ctrl+Shift+E\nclick host:repeat\nclick host:start\nfinish");
    fs::remove_all(into);
    play("key Ctrl+Z\nkey Ctrl+S\nwait 2\nfinish");
    EXPECT_FALSE(fs::exists(into));
}

TEST_F(EditorHostExport, RepeatedExportsEndWithTheirGraph) {
    folder.write("other.json", rock);
    open(rock);
    HostChoices chosen;
    chosen.into = "out";
    repeat_export(state, chosen, true);
    EXPECT_TRUE(find_repeated_export(state, *chosen.host));
    open_file(state, file);
    EXPECT_TRUE(find_repeated_export(state, *chosen.host));
    open_file(state, folder.path() / "other.json");
    EXPECT_FALSE(find_repeated_export(state, *chosen.host));
}

TEST_F(EditorHostExport, EveryHostIsOffered) {
    open(rock);
    std::string script = "key Ctrl+Shift+E\n";
    for (const Host& host : hosts())
        script += "click host:to:" + std::string(host.name) + "\n";
    play(script + "key Escape\nassert no-target host:start");
}

TEST_F(EditorHostExport, AnErrorIsStatedAndWritesNothing) {
    open(rock);
    HostChoices chosen;
    chosen.mesh = (folder.path() / "missing.obj").string();
    chosen.into = "out";
    start_host_export(state, chosen);
    play("finish");
    EXPECT_NE(state.tasks.failed.find("No file was exported. "), std::string::npos);
    EXPECT_FALSE(fs::exists(folder.path() / "out"));
}

}  // namespace
}  // namespace wrinkle::editor
