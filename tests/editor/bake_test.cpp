// Tests of bakes from the editor: the bytes equal those of `wrinkle bake`; cancellation, errors and
// messages.
#include "editor/model/bake/bake.h"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include "baking.h"
#include "editor/model/document/field.h"
#include "editor/model/document/files.h"
#include "editor/view/commands/commands.h"
#include "editor/view/panels/bake_dialog.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;
using Names = std::vector<std::string>;

// Two triangles over the same uv area, the second mirrored, and a third in the next UDIM tile.
const char* const folded = R"(v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
vt 0 0
vt 1 0
vt 0 1
vt 1 0
vt 2 0
vt 1 1
f 1/1 2/2 3/3
f 2/2 4/1 3/3
f 1/4 2/5 3/6
)";

#if defined(__SANITIZE_ADDRESS__)
constexpr uint32_t long_bake = 4096;  // texels a row; it takes as long as a larger one elsewhere
#else
constexpr uint32_t long_bake = 16384;
#endif

class EditorBake : public Baking {
protected:
    void bake(const BakeChoices& chosen) {
        start_bake(state, chosen);
        play("finish");
    }
    // Returns the output of `wrinkle bake` for the file on disk.
    std::string program(const std::string& options, const std::string& out) const {
        return program_output("bake " + file.string() + " --size 256 " + options + " -o " +
                              (folder.path() / out).string());
    }
    bool exists(const std::string& name) const { return fs::exists(folder.path() / name); }
    // Starts a bake and returns when some of it is done.
    void start_long_bake(const std::string& into) {
        BakeChoices chosen = choices({"normal", "height"}, into);
        chosen.width = long_bake;
        start_bake(state, chosen);
        ASSERT_TRUE(state.tasks.running);
        while (state.tasks.running->progress().done == 0 && !state.tasks.running->ended())
            usleep(1000);
        ASSERT_FALSE(state.tasks.running->ended()) << state.tasks.running->outcome().sentence;
    }
};

TEST_F(EditorBake, TheDialogWritesTheBytesOfTheProgram) {
    open(rock);
    play(
        "key Ctrl+B\nassert target bake:start\nclick bake:map:slopes\nclick bake:map:height\n"
        "click bake:mesh\nclick bake:mesh:torus\nclick bake:size\nclick bake:size:256\n"
        "click bake:start\nassert no-target bake:start\nfinish\n"
        "assert status Baked 3 maps into graph_maps in");
    program("--mesh torus --map normal,slopes,height", "theirs");
    for (const char* name : {"/normal.png", "/slopes.exr", "/height.png"})
        expect_same("graph_maps" + std::string(name), "theirs" + std::string(name));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "graph_maps"), {}), 3);
}

TEST_F(EditorBake, EveryChoiceIsAnOptionOfTheProgram) {
    open(rock);
    const std::string mesh = folder.write("folded.obj", folded).string();
    BakeChoices chosen = choices({"normal"}, "one.tif");
    chosen.object_space = chosen.green_down = true;
    chosen.stored = stored_kind("tif u16");
    bake(chosen);
    program("--mesh sphere --space object --dx --type u16", "theirs.tif");
    expect_same("one.tif", "theirs.tif");

    chosen = choices({"normal", "derivative"}, "deep/er");
    chosen.stored = stored_kind("exr float");
    chosen.mesh = mesh;
    chosen.udim = true;
    bake(chosen);
    program("--mesh " + mesh + " --map normal,derivative --type float --udim", "theirs");
    for (const char* name : {"/normal.1001.exr", "/derivative.1002.exr"})
        expect_same("deep/er" + std::string(name), "theirs" + std::string(name));
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "deep/er"), {}), 4);
}

TEST_F(EditorBake, WhatIsBakedIsTheDocumentAtTheStart) {
    open(rock);
    const auto set_scale = [&](double scale) {
        const NodeType* type = state.type_of("noise");
        const Port& port = type->ports[type->find_input("scale")];
        state.commit("scale", with_number(state.document(), "noise", port, 0, scale));
    };
    set_scale(7);
    frame();
    start_bake(state, choices({"height"}, "ours.png"));
    set_scale(2);
    play("finish\nassert status Baked ours.png in");
    program("--mesh sphere --map height", "saved.png");
    EXPECT_FALSE(text_of(folder.path() / "ours.png") == text_of(folder.path() / "saved.png"));
    play("key Ctrl+Z\nkey Ctrl+S");
    program("--mesh sphere --map height", "theirs.png");
    expect_same("ours.png", "theirs.png");
}

TEST_F(EditorBake, ACancelledOneLeavesNothing) {
    open(rock);
    start_long_bake("new/maps");
    EXPECT_EQ(state.tasks.running->progress().total, uint64_t{long_bake} * long_bake);
    play("wait\nassert target task:cancel\nclick task:cancel\nfinish");
    EXPECT_EQ(state.status, "Baking 2 maps was cancelled. Nothing was written.");
    EXPECT_FALSE(exists("new"));
    folder.write("kept.txt", "kept");
    start_long_bake(".");
    cancel_task(state);
    play("finish");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2);  // with the graph
}

TEST_F(EditorBake, QuittingAsksFirst) {
    open(rock);
    start_long_bake("maps");
    play("key Ctrl+Q\nassert target answer:stop\nclick answer:cancel\nassert target task:cancel");
    EXPECT_FALSE(state.quit);
    EXPECT_TRUE(state.tasks.running);
    play("key Ctrl+Q\nclick answer:stop");
    EXPECT_TRUE(state.quit);
    state.tasks = {};  // as at the end of the program
    EXPECT_FALSE(exists("maps"));
}

TEST_F(EditorBake, WhatCannotBeWrittenIsSaidAndTriedAgain) {
    open(rock);
    bake(choices({"normal", "height"}, "graph.json/maps"));
    EXPECT_EQ(state.tasks.failed, "The maps were not written: its folder is no longer there.");
    rlimit old = {};
    getrlimit(RLIMIT_FSIZE, &old);
    const rlimit small = {1000, old.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    start_bake(state, choices({"normal"}, "maps/normal.png"));
    const TaskOutcome outcome = state.tasks.running->outcome();
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(outcome.sentence, "The maps were not written: it is larger than a file may be here.");
    EXPECT_FALSE(exists("maps"));
    play("wait\nclick task:again\nfinish\nassert status Baked normal.png in");
    EXPECT_TRUE(exists("maps/normal.png"));
}

TEST_F(EditorBake, AGraphWithErrorsIsNotBaked) {
    std::string broken = rock;
    broken.replace(broken.find("\"scale\": 3.0"), 12, "\"scala\": 3.0");
    open(broken);
    play("key Ctrl+B");
    EXPECT_EQ(why_no_bake(state), "The graph has errors. They are in the list of problems.");
    play("click bake:start\nassert target bake:start\nkey Escape\nassert no-target bake:start");
    EXPECT_FALSE(state.tasks.running);
    bake(choices({"normal"}, "maps"));
    EXPECT_EQ(state.tasks.failed.find("No map can be baked. noise: "), 0U) << state.tasks.failed;
    EXPECT_FALSE(exists("maps"));
    open(R"({ "wrinkle": 1, "nodes": { "noise": { "type": "gradient_noise" } } })");
    EXPECT_FALSE(run_command(state, "bake"));
    EXPECT_EQ(no_maps(state), "The graph has no output to bake.");
}

TEST_F(EditorBake, AMeshThatCannotBeBakedOntoIsSaid) {
    open(rock);
    const auto refused = [&](const std::string& mesh) {
        BakeChoices chosen = choices({"normal"}, "maps");
        chosen.mesh = mesh;
        bake(chosen);
        EXPECT_FALSE(exists("maps"));
        return state.tasks.failed;
    };
    const std::string bare = folder.write("bare.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(refused(bare), "No map can be baked. bare.obj: the mesh has no uvs (set 0).");
    const std::string far = folder.write("far.obj",
                                         "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 5 5\nvt 7 5\nvt 5 6\n"
                                         "f 1/1 2/2 3/3\n");
    EXPECT_NE(refused(far).find("no triangle lies in the uv square"), std::string::npos);
    EXPECT_NE(refused(folder.path() / "gone.obj").find("gone.obj: "), std::string::npos);
}

TEST_F(EditorBake, WarningsAreProblemsUntilTheyAreDismissed) {
    open(rock);
    BakeChoices chosen = choices({"height"}, "maps");
    chosen.mesh = folder.write("folded.obj", folded);
    bake(chosen);
    Names told;
    for (const Diagnostic& warning : state.tasks.warnings.list())
        told.push_back(warning.message);
    ASSERT_EQ(told.size(), 4U);
    EXPECT_EQ(told[0], "folded.obj: 1 of 3 triangles lie outside of the uv square");
    EXPECT_EQ(told[1], "folded.obj: 1 of 3 triangles are mirrored in uv");
    EXPECT_EQ(told[2].find("folded.obj: "), 0U);
    EXPECT_NE(told[2].find(" texels are covered by more than one triangle"), std::string::npos);
    EXPECT_EQ(told[3].find("graph.json: the map 'height' holds "), 0U) << told[3];
    play("assert target problem:1\nclick dismiss:1\nassert target problem:1");
    ASSERT_EQ(state.tasks.warnings.list().size(), 3U);
    EXPECT_EQ(state.tasks.warnings.list()[0].message, told[1]);
    open_file(state, folder.write("other.json", rock));
    play("wait\nassert no-target problem:1");
}

TEST_F(EditorBake, TheLastChoicesComeBack) {
    open(rock);
    play(
        "key Ctrl+B\nclick bake:map:height\nclick bake:map:normal\nclick bake:dx\n"
        "click bake:object\nclick bake:size\nclick bake:size:512\nclick bake:stored\n"
        "click bake:stored:tif-u16\nkey Escape\nkey Ctrl+B");
    EXPECT_EQ(state.bake_dialog.choices, usual_bake(state, state.view.preview_view.mesh))
        << "nothing was baked with them";
    EXPECT_EQ(state.bake_dialog.choices.maps, Names{"normal"});
    play(
        "click bake:map:height\nclick bake:map:normal\nclick bake:dx\nclick bake:object\n"
        "click bake:size\nclick bake:size:512\nclick bake:stored\nclick bake:stored:tif-u16\n"
        "click bake:start\nfinish");
    EXPECT_TRUE(exists("graph_maps/height.tif"));
    const BakeChoices again = usual_bake(state, state.view.preview_view.mesh);
    EXPECT_EQ(again.maps, Names{"height"});
    EXPECT_EQ(again.width, 512U);
    EXPECT_TRUE(again.green_down && again.object_space);
    EXPECT_EQ(again.stored->key, "tif u16");
    std::string trouble;
    write_settings(state.keeping.folders, state.keeping.settings);
    EXPECT_EQ(read_settings(state.keeping.folders, trouble).bake, state.keeping.settings.bake);
    BakeSettings odd;
    odd.maps = "gone,,";
    odd.width = 77;
    odd.stored = "gif";
    state.keeping.settings.bake = odd;
    EXPECT_EQ(usual_bake(state, state.view.preview_view.mesh).maps, Names{"normal"});
    EXPECT_EQ(usual_bake(state, state.view.preview_view.mesh).width, 1024U);
    EXPECT_EQ(usual_bake(state, state.view.preview_view.mesh).stored->key, "png u8");
}

TEST_F(EditorBake, TheDialogSaysWhatIsWrittenAndReplaced) {
    open(rock);
    EXPECT_EQ(what_is_written(choices({"normal"}, "a/b.png")), "Writes b.png.");
    EXPECT_EQ(what_is_written(choices({"normal", "slopes"}, "a/b.png")),
              "Writes normal.png and slopes.exr into a/b.png.");
    EXPECT_EQ(what_is_written(choices({"normal"}, "b.exr")), "Writes normal.png into b.exr.");
    BakeChoices tiles = choices({"slopes"}, "maps");
    tiles.udim = true;
    EXPECT_EQ(what_is_written(tiles), "Writes slopes.1001.exr into maps, and so on for each tile.");
    fs::create_directory(folder.path() / "graph_maps");
    folder.write("graph_maps/normal.png", "");
    play("key Ctrl+B\nwait");
    EXPECT_EQ(state.bake_dialog.replaces, "normal.png is there already and is replaced.");
    play("click bake:map:height\nclick bake:map:normal\nwait");
    EXPECT_EQ(state.bake_dialog.replaces, "");
    play("click bake:map:height\nwait");
    EXPECT_EQ(why_no_bake(state), "Choose a map.");
}

TEST_F(EditorBake, MeshAndPlaceAreFoundInTheBrowser) {
    open(rock);
    folder.write("folded.obj", folded);
    fs::create_directory(folder.path() / "there");
    play(
        "key Ctrl+B\nclick bake:mesh\nclick bake:mesh:browse\nassert target file:folded.obj\n"
        "assert no-target file:graph.json\ndouble file:folded.obj\nassert target bake:start");
    EXPECT_EQ(fs::path(state.bake_dialog.choices.mesh).filename(), "folded.obj");
    play("click bake:browse\nkey Ctrl+A\ntype there/out\nkey Enter\nassert target bake:start");
    EXPECT_TRUE(fs::path(state.bake_dialog.choices.into).is_absolute());
    play("click bake:size\nclick bake:size:256\nclick bake:start\nfinish");
    EXPECT_TRUE(exists("there/out/normal.png"));
}

TEST(ProgressWords, SayHowFarHowFastAndHowLong) {
    EXPECT_EQ(progress_words(0, 0, 1, ""), "");
    EXPECT_EQ(progress_words(1, 2, 1, ""), "1 of 2 steps");
    EXPECT_EQ(progress_words(0, 1000, 1, "texels"), "0 %");
    EXPECT_EQ(progress_words(2'000'000, 8'000'000, 4, "texels"),
              "25 %, 500 ktexels/s, about 12 s left");
}

}  // namespace
}  // namespace wrinkle::editor
