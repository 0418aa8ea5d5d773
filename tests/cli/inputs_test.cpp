// Tests of wrinkle inputs and of the same list in dependency files: all files that an output
// depends on, with the names that the build system uses.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

class InputsTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("graphs/top.json", R"({"wrinkle": 1,
  "inputs": {"map": {"type": "image", "default": "../images/b.png"}},
  "nodes": {
    "one": {"type": "graph:parts/inner.json"},
    "two": {"type": "graph:../graphs/parts/inner.json"},
    "idle": {"type": "image", "in": {"image": {"file": "../images/idle.png"}}}},
  "outputs": {"normal": {"from": "one.normal"}}})");
        put("graphs/parts/inner.json", R"({"wrinkle": 1, "nodes": {
    "bumps": {"type": "height_map", "in": {"image": "../../images/a.png"}},
    "end": {"type": "resolve", "in": {"gradient": {"from": "bumps.gradient"}}}},
  "outputs": {"normal": {"from": "end.normal"}}})");
        for (const char* name : {"images/a.png", "images/b.png", "images/idle.png"})
            put(name, "");
    }
    const std::string listed =
        "graphs/top.json\ngraphs/parts/inner.json\nimages/idle.png\nimages/b.png\nimages/a.png\n";
};

TEST_F(InputsTest, ListsGraphsImagesAndPlugins) {
    const Ran ran = run({"inputs", "graphs/top.json", "--root", "."});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, listed);
    put("ripples.json", R"({"wrinkle": 1, "nodes": {"r": {"type": "ripples"}},
        "outputs": {"height": {"from": "r.height"}}})");
    const Ran plugin = run({"inputs", "ripples.json", "--plugin-path", WRINKLE_RIPPLES});
    EXPECT_EQ(plugin.code, 0) << plugin.err;
    EXPECT_EQ(plugin.out, "ripples.json\n" WRINKLE_RIPPLES "\n");
}

TEST_F(InputsTest, NamesAreSpelledAsTheGraphs) {
    const std::string here = folder.string() + "/";
    const Ran ran = run({"inputs", here + "graphs/top.json", "--root", "."});
    EXPECT_TRUE(says(ran.out, here + "graphs/parts/inner.json\n" + here + "images/idle.png"));
    const Ran piped = run({"inputs", "-"}, get("graphs/parts/inner.json"));
    EXPECT_EQ(piped.code, 0) << piped.err;
    EXPECT_EQ(piped.out, "") << "what lies outside the root is no input";
    fs::create_directory_symlink(folder / "graphs/parts", folder / "link");
    const Ran linked = run({"inputs", "link/inner.json", "--root", "."});
    EXPECT_EQ(linked.out, "link/inner.json\n" + here + "images/a.png\n");
}

TEST_F(InputsTest, JsonNamesTheKindOfEach) {
    const Ran ran =
        run({"inputs", "graphs/top.json", "graphs/parts/inner.json", "--root", ".", "--json"});
    const json::Value graphs = parsed(ran.out).find("graphs");
    ASSERT_EQ(graphs.size(), 2u);
    const json::Value second = graphs.at(1);
    EXPECT_EQ(second.find("file").as_string(), "graphs/parts/inner.json");
    ASSERT_EQ(second.find("inputs").size(), 2u);
    const json::Value image = second.find("inputs").at(1);
    EXPECT_EQ(image.find("path").as_string(), "images/a.png");
    EXPECT_EQ(image.find("kind").as_string(), "image");
}

TEST_F(InputsTest, AnImageMayBeMissingAndASubgraphMayNot) {
    fs::remove(folder / "images/a.png");
    EXPECT_EQ(run({"inputs", "graphs/top.json", "--root", "."}).out, listed);
    fs::remove(folder / "graphs/parts/inner.json");
    const Ran ran = run({"inputs", "graphs/top.json", "--root", "."});
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(ran.out, "");
    EXPECT_TRUE(says(ran.err, "parts/inner.json"));
}

TEST_F(InputsTest, DepfileNamesTheSame) {
    ASSERT_EQ(run({"compile", "graphs/top.json", "--root", ".", "-o", "g.glsl", "-MD"}).code, 0);
    std::string rule = "g.glsl:";
    for (const char c : "\n" + listed.substr(0, listed.size() - 1))
        rule += c == '\n' ? " \\\n  " : std::string(1, c);
    EXPECT_EQ(get("g.glsl.d"), rule + "\n");
}

}  // namespace
}  // namespace wrinkle::test
