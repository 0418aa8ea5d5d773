// Tests of exports to hosts from the editor: the files equal those of `wrinkle export`.
#include "editor/model/hosts/host_export.h"
#include "baking.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

using EditorHostExport = Baking;

TEST_F(EditorHostExport, TheDialogWritesTheFilesOfTheProgram) {
    open(rock);
    play(
        "key Ctrl+Shift+E\nassert target host:start\nclick host:to\nclick host:to:gltf\n"
        "click host:mesh\nclick host:mesh:torus\nclick host:size\nclick host:size:256\n"
        "click host:start\nassert no-target host:start\nfinish\n"
        "assert status Wrote 2 files for glTF 2.0 into graph_gltf");
    program_output("export " + file.string() + " --to gltf --mesh torus --size 256 -o " +
                   (folder.path() / "theirs").string());
    expect_same("graph_gltf/graph.glb", "theirs/graph.glb");
    expect_same("graph_gltf/README.txt", "theirs/README.txt");
}

TEST_F(EditorHostExport, EveryHostIsOffered) {
    open(rock);
    std::string script = "key Ctrl+Shift+E\n";
    for (const Host& host : hosts())
        script += "click host:to\nclick host:to:" + std::string(host.name) + "\n";
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
