// Tests of bake options in the editor: each option has the effect that it has in `wrinkle bake`, is
// remembered, and is in the command that the dialog copies.
#include <cstdlib>

#include "baking.h"
#include "base/text.h"
#include "editor/model/bake/bake.h"
#include "editor/model/document/folders.h"
#include "editor/view/panels/bake_dialog.h"

namespace wrinkle::editor {
namespace {
namespace fs = std::filesystem;

class BakeOptionRows : public Baking {
protected:
    BakeOptionRows() { open(rock); }
    void bake(BakeChoices chosen, const fs::path& into) {
        chosen.into = into;
        start_bake(state, chosen);
        play("finish");
        EXPECT_EQ(state.tasks.failed, "");
    }
    void program(const std::string& options, const std::string& out) const {
        program_output("bake " + file.string() + " --mesh sphere --size 256 " + options + " -o " +
                       (folder.path() / out).string());
    }
    std::string bytes(const fs::path& name) const { return text_of(folder.path() / name); }
    // Checks that the bake and the command copied by the dialog write the same files.
    void expect_the_command_bakes_it(const BakeChoices& chosen, const std::string& into) {
        bake(chosen, "ours/" + into);
        BakeChoices theirs = chosen;
        theirs.into = folder.path() / "theirs" / into;
        const std::string command = bake_command(theirs, file);
        for (const std::string_view line : split(command, '\n')) {
            ASSERT_TRUE(line.starts_with("wrinkle ")) << line;
            const std::string said = program_output(std::string(line.substr(8)));
            EXPECT_EQ(said.find("error"), said.npos) << line << "\n" << said;
        }
        size_t count = 0;
        for (const char* side : {"ours", "theirs"})
            for (const auto& each : fs::recursive_directory_iterator(folder.path() / side)) {
                if (!each.is_regular_file()) continue;
                const fs::path name = fs::relative(each.path(), folder.path() / side);
                expect_same("ours" / name, "theirs" / name);
                ++count;
            }
        EXPECT_GT(count, 1U) << command;
        fs::remove_all(folder.path() / "ours");
        fs::remove_all(folder.path() / "theirs");
    }
};

TEST_F(BakeOptionRows, EachDoesWhatItDoesInTheProgram) {
    const auto expect = [&](const BakeTuning& tuning, const std::string& options) {
        BakeChoices chosen = choices({"height"});
        chosen.stored = stored_kind("tif u16");
        bake(chosen, "usual.tif");
        chosen.tuning = tuning;
        bake(chosen, "ours.tif");
        program("--map height --type u16 " + options, "theirs.tif");
        expect_same("ours.tif", "theirs.tif");
        EXPECT_FALSE(bytes("ours.tif") == bytes("usual.tif")) << options << " does nothing";
    };
    expect({.scale = 0.25}, "--scale 0.25");
    expect({.samples = 1}, "--samples 1");
    expect({.dilate = 0}, "--dilate 0");
    expect({.compression = "lzw"}, "--compression lzw");
    expect({.tile = 128}, "--tile 128");
}

TEST_F(BakeOptionRows, PacksAreMapsOfTheirOwn) {
    BakeChoices chosen = choices({});
    chosen.packs = "rh: r=roughness g=height ; a=height r=normal.g";
    bake(chosen, "maps");
    program("--pack \"rh: r=roughness g=height\" --pack \"a=height r=normal.g\"", "theirs");
    expect_same("maps/rh.png", "theirs/rh.png");
    expect_same("maps/packed.png", "theirs/packed.png");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "maps"), {}), 2);
}

TEST_F(BakeOptionRows, TheCommandBakesTheSame) {
    expect_the_command_bakes_it(choices({"normal", "slopes", "height"}), "maps");
    BakeChoices chosen = choices({"normal", "slopes", "height"});
    chosen.packs = "rh: r=roughness g=height";
    chosen.stored = stored_kind("png u16");
    chosen.object_space = chosen.green_down = true;
    chosen.tuning = {0.5, 16, 3, "lzw", 64};
    expect_the_command_bakes_it(chosen, "it's a folder");
    chosen = choices({"normal"});
    chosen.udim = true;
    chosen.stored = stored_kind("tif u8");
    chosen.tuning = {1, 4, 16, "none", 64};
    expect_the_command_bakes_it(chosen, "one.tif");
    chosen.stored = stored_kind("exr half");
    chosen.tuning.compression = "piz";
    expect_the_command_bakes_it(chosen, "in/folders");
}

TEST_F(BakeOptionRows, MomentsOfPicturesAreThoseOfTheProgram) {
    open(R"({"wrinkle": 1, "nodes": {
        "map": {"type": "tangent_normal_map", "in": {"image": ")" +
         texture("weave_normal.png") + R"("}},
        "normal": {"type": "resolve", "in": {"gradient": {"from": "map.gradient"}}}},
        "outputs": {"normal": {"from": "normal.normal"}}})");
    BakeChoices chosen = choices({"normal", "slopes"});
    chosen.width = 64;  // one texel covers many texels of the image
    expect_the_command_bakes_it(chosen, "maps");
}

// The editor offers exactly the formats and types that `wrinkle bake` accepts.
TEST_F(BakeOptionRows, EveryFormatAndTypeOfTheProgramIsOffered) {
    std::vector<std::string> offered, taken;
    for (const StoredAs& kind : stored_kinds())
        offered.push_back(kind.key);
    for (const std::string format : {"png", "tif", "exr", "hdr"})
        for (const std::string type : {"u8", "u16", "half", "float"}) {
            const fs::path out = folder.path() / (type + "." + format);
            program_output("bake " + file.string() + " --mesh sphere --size 16 --type " + type +
                           " -o " + out.string());
            if (fs::exists(out)) taken.push_back(format + " " + type);
        }
    EXPECT_EQ(offered, taken);
    BakeChoices chosen = choices({"normal"});
    chosen.stored = stored_kind("hdr float");
    expect_the_command_bakes_it(chosen, "maps");
}

TEST_F(BakeOptionRows, MapsNeedNotBeSquare) {
    play(
        "key Ctrl+B\nclick bake:size\nclick bake:size:256\nclick bake:height\n"
        "click bake:height:64\nclick bake:into\nkey Ctrl+A\ntype maps\nclick bake:start\nfinish");
    EXPECT_EQ(state.tasks.failed, "");
    program_output("bake " + file.string() + " --mesh sphere --size 256x64 -o " +
                   (folder.path() / "theirs.png").string());
    expect_same("maps/normal.png", "theirs.png");
    EXPECT_EQ(usual_bake(state, state.view.preview_view.mesh).height(), 64U);
    BakeChoices chosen = choices({"normal"});
    chosen.square_or_height = 128;
    expect_the_command_bakes_it(chosen, "maps");
}

TEST_F(BakeOptionRows, WhatIsAskedForInTheDialogIsBakedAndRemembered) {
    play(R"(
        key Ctrl+B
        click bake:map:height
        click bake:map:normal
        click bake:size
        click bake:size:256
        click bake:packs
        type rn: r=roughness g=normal.r
        click bake:scale
        key Ctrl+A
        type 2
        click bake:samples
        click bake:samples:64
        click bake:dilate
        key Ctrl+A
        type 5
        click bake:stored
        click bake:stored:tif-u16
        click bake:compression
        click bake:compression:none
        click bake:tile
        click bake:tile:64
        click bake:into
        key Ctrl+A
        type maps
        click bake:copy
        click bake:start
        finish
        assert status Baked 2 maps into maps in)");
    program(
        "--map height --pack \"rn: r=roughness g=normal.r\" --scale 2 --samples 64 --dilate 5 "
        "--type u16 --format tif --compression none --tile 64",
        "theirs");
    expect_same("maps/height.tif", "theirs/height.tif");
    expect_same("maps/rn.tif", "theirs/rn.tif");
    const std::string copied = ImGui::GetClipboardText();
    for (const char* part :
         {"--scale 2", "--samples 64", "--dilate 5", "--tile 64", " --map height ",
          "--compression none", "--pack 'rn: r=roughness.r g=normal.r'"})
        EXPECT_NE(copied.find(part), copied.npos) << part << "\n" << copied;
    std::string trouble;
    write_settings(state.keeping.folders, state.keeping.settings);
    const BakeSettings kept = read_settings(state.keeping.folders, trouble).bake;
    EXPECT_EQ(trouble, "");
    EXPECT_EQ(kept.tuning, (BakeTuning{2, 64, 5, "none", 64}));
    EXPECT_EQ(kept.packs, "rn: r=roughness g=normal.r");
    state.keeping.settings.bake = kept;
    EXPECT_EQ(usual_bake(state, state.view.preview_view.mesh).tuning, kept.tuning);
    EXPECT_EQ(usual_bake(state, state.view.preview_view.mesh).packs, kept.packs);
}

TEST_F(BakeOptionRows, ThePresetThatIsShownIsBaked) {
    open(R"({"wrinkle": 1, "inputs": {"tint": {"type": "color", "default": [1, 0, 0]}},
        "presets": {"Blue": {"tint": [0, 0, 0.25]}},
        "nodes": {"mix": {"type": "vec3_mix", "in": {"a": {"from": "input.tint"}}}},
        "outputs": {"color": {"from": "mix.vector"}}})");
    play("key Shift+E\nclick preset\nclick preset:Blue\nkey Ctrl+B\nwait");
    BakeChoices chosen = choices({"color"});
    bake(chosen, "usual.png");
    chosen.preset = state.bake_dialog.choices.preset;
    EXPECT_EQ(what_is_written(chosen).find("Writes color.png with preset Blue"), 0U);
    bake(chosen, "ours.png");
    EXPECT_NE(text_of(folder.path() / "ours.png"), text_of(folder.path() / "usual.png"));
    expect_the_command_bakes_it(chosen, "maps");
}

TEST_F(BakeOptionRows, WhatCannotBeIsSaidBeforeItIsTried) {
    play("key Ctrl+B\nwait");
    BakeChoices& chosen = state.bake_dialog.choices;
    EXPECT_EQ(why_no_bake(state), "");
    chosen.packs = "r:oughness";
    EXPECT_EQ(why_no_bake(state).find("\"r:oughness\" packs no channels."), 0U);
    chosen.packs = "r=height; g=height";
    EXPECT_EQ(why_no_bake(state).find("Two maps would be called packed."), 0U);
    chosen.packs = "normal: r=height";
    EXPECT_EQ(why_no_bake(state).find("Two maps would be called normal."), 0U);
    chosen.packs = " ; ";
    EXPECT_EQ(why_no_bake(state), "");
    chosen.tuning.scale = 0;
    EXPECT_EQ(why_no_bake(state), "The scale is a number greater than 0.");
    BakeChoices gone = choices({});
    gone.packs = "r=nowhere";
    gone.into = "maps";
    start_bake(state, gone);
    play("finish");
    EXPECT_NE(state.tasks.failed.find("nowhere"), std::string::npos) << state.tasks.failed;
    EXPECT_FALSE(fs::exists(folder.path() / "maps"));
}

TEST_F(BakeOptionRows, SettingsThatFitNoOptionAreLeft) {
    BakeSettings odd;
    odd.tuning.samples = 5;
    odd.tuning.tile = 100;
    state.keeping.settings.bake = odd;
    EXPECT_EQ(usual_bake(state, state.view.preview_view.mesh).tuning, BakeTuning());
}

TEST_F(BakeOptionRows, ATildeLeadsHome) {
    const std::string before = std::getenv("HOME") ? std::getenv("HOME") : "";
    setenv("HOME", folder.path().c_str(), 1);
    EXPECT_EQ(with_home("~"), folder.path());
    EXPECT_EQ(with_home("~/a/b"), folder.path() / "a/b");
    for (const char* other : {"a/~", "~user/a", "/a", "a", ""})
        EXPECT_EQ(with_home(other), fs::path(other));
    bake(choices({"height"}), "~/at home");
    EXPECT_TRUE(fs::exists(folder.path() / "at home/height.png"));
    setenv("HOME", before.c_str(), 1);
}

}  // namespace
}  // namespace wrinkle::editor
