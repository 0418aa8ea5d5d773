// Tests that an output that is an input of the same run is an error before anything is written.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class OverwriteTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("map.png", "P6\n2 2\n255\nabcdefghijkl");  // its first bytes determine the format
        put("inner.json", tilt_graph("0.5"));
        put("g.json", R"({"wrinkle": 1, "nodes": {
            "sub": {"type": "graph:inner.json"},
            "map": {"type": "image", "in": {"image": "map.png"}}},
            "outputs": {"normal": {"from": "sub.normal"}, "color": {"from": "map.color"}}})");
        put("plane.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
        put("words", "--name x");
        fs::create_symlink("g.json", folder / "link.json");
        fs::create_hard_link(folder / "g.json", folder / "hard.json");
    }

    std::string content(const std::string& name) const {
        return fs::is_regular_file(folder / name) ? get(name) : "";
    }

    void expect_refused(const Names& words) {
        std::string line;
        for (const std::string& word : words)
            line += word + " ";
        const Names names = files();
        Names before;
        for (const std::string& name : names)
            before.push_back(content(name));
        const Ran ran = run(words);
        EXPECT_TRUE(ran.code == 1 || ran.code == 2) << line << ran.code << ran.err;
        EXPECT_TRUE(says(ran.err, "would replace the input") ||
                    says(ran.err, "two outputs would be written to one file"))
            << line << ran.err;
        EXPECT_EQ(files(), names) << line;
        for (size_t i = 0; i < names.size(); ++i)
            EXPECT_EQ(content(names[i]), before[i]) << line << names[i];
    }
};

TEST_F(OverwriteTest, NoCommandReplacesWhatItReads) {
    const std::string by_parent = "../" + folder.filename().string() + "/g.json";
    for (const std::string& name : Names{"g.json", "./g.json", "link.json", "hard.json",
                                         "inner.json", "map.png", by_parent}) {
        expect_refused({"compile", "g.json", "-o", name});
        expect_refused({"compile", "g.json", "-o", "out", "--reflect", name});
        expect_refused({"compile", "g.json", "-o", "out", "-MD", "-MF", name});
    }
    expect_refused({"compile", "g.json", "@words", "-o", "words"});
    expect_refused({"convert", "map.png", "--from", "height", "--to", "normal", "-o", "map.png"});
    expect_refused({"render", "g.json", "-o", "map.png"});
    expect_refused({"compare", "map.png", "map.png", "-o", "map.png"});
    expect_refused({"compare", "map.png", "map.png", "-o", "a.exr", "--exposure-map", "a.exr"});
    put("out/README.txt", "--name x");
    expect_refused(
        {"export", "g.json", "@out/README.txt", "--to", "gltf", "--size", "8", "-o", "out"});
    expect_refused({"merge", "g.json", "inner.json", "inner.json", "-o", "g.json"});
    expect_refused({"merge", "inner.json", "g.json", "hard.json"});
    const Names bake = {"bake", "g.json", "--mesh", "plane.obj", "--size", "8", "--map", "color"};
    for (const Names& more :
         {Names{"-o", "map.png"}, Names{"-o", "new.png", "-MD", "-MF", "plane.obj"},
          Names{"-o", "new.png", "-MD", "-MF", "g.json"}}) {
        Names words = bake;
        words.insert(words.end(), more.begin(), more.end());
        expect_refused(words);
    }
}

TEST_F(OverwriteTest, NoGraphOfSeveralReplacesWhatAnotherReads) {
    put("top/inner.json", tilt_graph());
    put("top/uses.json", R"({"wrinkle": 1, "nodes": {"sub": {"type": "graph:../inner.json"}},
        "outputs": {"normal": {"from": "sub.normal"}}})");
    expect_refused({"compile", "g.json", "link.json", "-o", "out", "--reflect", "."});
    expect_refused({"compile", "top/inner.json", "top/uses.json", "--root", ".", "-o", "out",
                    "--reflect", "."});
    expect_refused({"compile", "g.json", "inner.json", "-o", "out", "-MD", "-MF", "map.png"});
}

TEST_F(OverwriteTest, TwoOutputsOfOneFileAreRefused) {
    fs::create_symlink("out", folder / "same");
    expect_refused({"compile", "g.json", "-o", "out", "--reflect", "same"});
    expect_refused({"compile", "g.json", "-o", "out", "--reflect", "./out"});
}

TEST_F(OverwriteTest, AManifestDoesNotReplaceItsPlugin) {
    fs::copy_file(WRINKLE_RIPPLES, folder / "ripples.so");
    fs::create_hard_link(folder / "ripples.so", folder / "ripples.so.json");
    expect_refused({"plugins", "--manifest", "./ripples.so"});
}

TEST_F(OverwriteTest, AReportReplacesNoOtherPage) {
    put("inner.test.json", R"({"glsl": true})");
    put("golden/inner.glsl", "old");
    put("golden/index.html", "mine");
    const Ran ran = run({"test", "inner.test.json", "--report", "golden"});
    EXPECT_EQ(ran.code, 3) << ran.err;
    EXPECT_TRUE(says(ran.err, "golden/index.html: is not of a report"));
    EXPECT_EQ(get("golden/inner.glsl"), "old");
    EXPECT_EQ(get("golden/index.html"), "mine");
}

TEST_F(OverwriteTest, FormattingStillReplacesItsGraph) {
    put("loose.json", "{\"wrinkle\":1,\"nodes\":{}}");
    EXPECT_EQ(run({"format", "loose.json"}).code, 0);
    EXPECT_NE(get("loose.json"), "{\"wrinkle\":1,\"nodes\":{}}");
}

}  // namespace
}  // namespace wrinkle::test
