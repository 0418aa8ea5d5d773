// Tests of the files that a pattern such as *.json matches in addition to graphs: tests, presets,
// and names that look like options.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class GraphFilesTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("a.json", tilt_graph());
        put("b.json", tilt_graph("0.5"));
        put("a.test.json", R"({"glsl": true})");
        put("b.preset.json", "{}");
    }

    // Runs a command line in a shell that expands patterns; `wrinkle` is the program.
    Ran shell(const std::string& line) {
        const std::string wrinkle = std::exchange(program, "/bin/sh");
        const Ran ran = run({"-c", "wrinkle() { " + wrinkle + " \"$@\"; }; " + line});
        program = wrinkle;
        return ran;
    }
};

TEST_F(GraphFilesTest, TestsAndPresetsAmongSeveralFilesAreLeftOutWithAWarning) {
    for (const std::string command :
         {"check", "compile -o out", "inputs", "format", "upgrade", "format --check"}) {
        const Ran ran = shell("wrinkle " + command + " *.json");
        EXPECT_EQ(ran.code, 0) << command << ran.err;
        EXPECT_TRUE(says(ran.err,
                         "warning: left out, as tests and presets are not graphs: "
                         "a.test.json, b.preset.json\n"))
            << command;
    }
    EXPECT_TRUE(exists("out/a.glsl") && exists("out/b.glsl") && !exists("out/a.test.glsl"));
    EXPECT_EQ(get("a.test.json"), R"({"glsl": true})");
}

TEST_F(GraphFilesTest, TheWarningIsPartOfTheJson) {
    const Ran ran = shell("wrinkle check --diagnostics json *.json");
    EXPECT_TRUE(says(ran.err, "a.test.json, b.preset.json"));
    EXPECT_EQ(parsed(ran.err).find("diagnostics").size(), 1u);
}

TEST_F(GraphFilesTest, ATestOrAPresetAloneIsAnErrorThatSaysWhatToDo) {
    for (const Names& words : std::vector<Names>{{"check"},
                                                 {"compile"},
                                                 {"inputs"},
                                                 {"format"},
                                                 {"upgrade"},
                                                 {"eval", "--at", "{}"},
                                                 {"render", "-o", "x.png"}}) {
        Names test = words, preset = words;
        test.push_back("a.test.json");
        preset.push_back("b.preset.json");
        Ran ran = run(test);
        EXPECT_EQ(ran.code, 1) << words[0];
        EXPECT_TRUE(says(ran.err,
                         "a.test.json: error: is a regression test, not a graph (wrinkle "
                         "test runs it)"));
        ran = run(preset);
        EXPECT_EQ(ran.code, 1) << words[0];
        EXPECT_TRUE(says(ran.err, "b.preset.json: error: is a preset, not a graph"));
    }
}

TEST_F(GraphFilesTest, AFileWhoseNameLooksLikeAnOptionIsRefused) {
    put("@opts.json", "--plugin-path evil.so");
    put("opts.json", "--name x");
    const Ran all = shell("wrinkle check *");
    EXPECT_EQ(all.code, 2);
    EXPECT_TRUE(says(all.err,
                     "'@opts.json' is the name of a file here; ./@opts.json or -- "
                     "@opts.json names that file, @./opts.json takes the words of "
                     "opts.json"));
    fs::remove(folder / "@opts.json");
    put("--plugin-path=evil.so", "");
    EXPECT_TRUE(
        says(shell("wrinkle check *").err, "'--plugin-path=evil.so' is the name of a file"));
}

TEST_F(GraphFilesTest, SuchAFileIsNamedByItsFolderOrBehindTwoDashes) {
    put("@g.json", tilt_graph());
    put("g.json", "--name other");
    const std::string text = run({"compile", "a.json", "--name", "x"}).out;
    for (const Names& words : std::vector<Names>{{"compile", "--name", "x", "./@g.json"},
                                                 {"compile", "--name", "x", "--", "@g.json"}})
        EXPECT_EQ(run(words).out, text);
    const Ran ran = run({"compile", "a.json", "@./g.json"});
    EXPECT_EQ(ran.out, run({"compile", "a.json", "--name", "other"}).out) << ran.err;
}

TEST_F(GraphFilesTest, TheSamplesCompileByOnePattern) {
    const Ran ran = shell("cd " WRINKLE_SOURCE_DIR "/graphs && wrinkle compile *.json -o '" +
                          (folder / "out").string() + "' -j8 -MD --cache '" +
                          (folder / "cache").string() + "'");
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(exists("out/noise_rock.glsl") && !exists("out/noise_rock.test.glsl"));
}

}  // namespace
}  // namespace wrinkle::test
