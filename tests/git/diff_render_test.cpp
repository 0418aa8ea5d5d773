// Tests of wrinkle diff --cost, --render and --report: numbers, images and costs of two graphs.
#include "git/repository.h"

namespace wrinkle::test {
namespace {

class DiffRenderTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        put("a.json", tilt_graph("0.75"));
        put("b.json", tilt_graph("0.25"));
    }

    // A graph with a normal map of graphs/textures.
    void put_map(const std::string& place, const std::string& image) const {
        put(place + "map.png", bytes_of(fs::path(WRINKLE_SOURCE_DIR "/graphs/textures") / image));
        put(place + "g.json", R"({"wrinkle": 1, "nodes": {
  "map": { "type": "tangent_normal_map", "in": { "image": "map.png" } },
  "end": { "type": "resolve", "in": { "gradient": { "from": "map.gradient" } } } },
  "outputs": { "normal": { "from": "end.normal" } } }
)");
    }
};

TEST_F(DiffRenderTest, AnglesAreThoseOfTheTwoTilts) {
    const Ran ran = run({"diff", "a.json", "b.json", "--render"});
    EXPECT_EQ(ran.code, 1) << ran.err;
    EXPECT_TRUE(says(ran.out, "b/points/0: normal [-0.6, 0, 0.8] -> [-0.2425356"));
    // atan(0.75) - atan(0.25)
    EXPECT_TRUE(says(ran.out, ", 22.83 degrees\n"));
    EXPECT_TRUE(says(ran.out, "b/render: FLIP 0."));
    EXPECT_TRUE(says(ran.out, "b.normals/render: degrees "));
    EXPECT_TRUE(ran.out.ends_with("\ndifferent\n")) << ran.out;
    EXPECT_FALSE(exists(".wrinkle"));
}

TEST_F(DiffRenderTest, CostsAreThoseOfCompile) {
    put("ten.json", ramp_graph("2"));
    put("one.json", R"({"wrinkle": 1, "nodes": {
  "uv": { "type": "separate_vec2", "in": { "vector": { "from": "surface.uv0" } } },
  "root": { "type": "square_root", "in": { "x": { "from": "uv.x" } } } },
  "outputs": { "value": { "from": "root.result" } } })");
    const auto count = [&](const std::string& graph, const char* name) {
        const json::Value root = parsed(run({"compile", graph, "--cost", "--json"}).out);
        const json::Value total = root.find("graphs").at(0).find("cost").find("total");
        return std::to_string(static_cast<int>(total.find(name).as_number()));
    };
    const Ran ran = run({"diff", "ten.json", "one.json", "--cost"});
    EXPECT_TRUE(says(ran.out, "transcendental " + count("ten.json", "transcendental") + " -> " +
                                  count("one.json", "transcendental")))
        << ran.err;
    EXPECT_FALSE(says(ran.out, "points/"));
    EXPECT_FALSE(says(run({"diff", "ten.json", "ten.json", "--cost"}).out, "cost"));
}

TEST_F(DiffRenderTest, CasesOfTheTestFileAreDrawnAsTestDoes) {
    const char* cases = R"({
  "points": [{ "normal": [0, 1, 0] }],
  "render": { "mesh": "plane", "size": "24x24", "view": "normal" }
})";
    for (const char* name : {"a", "b"}) {
        put(std::string(name) + ".test.json", cases);
        EXPECT_EQ(run({"test", std::string(name) + ".test.json", "--update"}).code, 0);
    }
    const Ran ran = run({"diff", "a.json", "b.json", "--report", "out"});
    EXPECT_EQ(ran.code, 1) << ran.err;
    EXPECT_TRUE(says(ran.out, "report: out/index.html\n"));
    EXPECT_EQ(get("out/expected/b.png"), get("golden/a.png"));
    EXPECT_EQ(get("out/actual/b.png"), get("golden/b.png"));
    const json::Value root = parsed(get("out/results.json"));
    EXPECT_EQ(root.find("before").as_string(), "a.json");
    EXPECT_EQ(root.find("after").as_string(), "b.json");
    EXPECT_EQ(root.find("changes").size(), 1U);
    const json::Value checks = root.find("checks");
    ASSERT_EQ(checks.size(), 4U);  // image, cost, point, GLSL
    EXPECT_EQ(checks.at(0).find("status").as_string(), "changed");
    EXPECT_TRUE(says(get("out/index.html"), "<h1>Different</h1>"));
}

TEST_F(DiffRenderTest, EqualGraphsAreTheSame) {
    const Ran ran = run({"diff", "a.json", "a.json", "--report", "out"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(ran.out, "report: out/index.html\nsame\n");
    EXPECT_TRUE(says(get("out/index.html"), "<h1>Same</h1>"));
    const json::Value results =
        parsed(run({"diff", "a.json", "a.json", "--cost", "--json"}).out).find("results");
    ASSERT_EQ(results.find("checks").size(), 1U);
    EXPECT_EQ(results.find("checks").at(0).find("status").as_string(), "passed");
}

TEST_F(DiffRenderTest, ImagesOfAnotherFolderAreADifference) {
    put_map("x/", "rivets_normal.png");
    put_map("y/", "weave_normal.png");
    EXPECT_EQ(run({"diff", "x/g.json", "y/g.json"}).out, "same\n");
    const Ran ran = run({"diff", "x/g.json", "y/g.json", "--render"});
    EXPECT_EQ(ran.code, 1) << ran.err;
    EXPECT_TRUE(ran.out.ends_with("\nsame graph, different files\n")) << ran.out;
}

TEST_F(DiffRenderTest, AGraphThatCannotBeRunIsTrouble) {
    std::string broken = tilt_graph();
    put("c.json", broken.replace(broken.find("resolve"), 7, "resolv"));
    const Ran ran = run({"diff", "a.json", "c.json", "--cost"});
    EXPECT_EQ(ran.code, 2);
    EXPECT_TRUE(says(ran.out, "c/case: c.json cannot be run: "));
    EXPECT_TRUE(ran.out.ends_with("\ndifferent\n")) << ran.out;
    const Ran dark = run({"diff", "a.json", "b.json", "--render"}, "", without_gl());
    EXPECT_EQ(dark.code, 3);
    EXPECT_TRUE(says(dark.out, "22.83 degrees"));
    EXPECT_TRUE(says(dark.err, "OpenGL"));
}

TEST_F(DiffRenderTest, AReportReplacesNoOtherPage) {
    put("site/index.html", "mine");
    const Ran ran = run({"diff", "a.json", "b.json", "--report", "site"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_TRUE(says(ran.err, "site/index.html: is not of a report"));
    EXPECT_EQ(files().size(), 4U);  // the graphs, and the page in its folder
    EXPECT_EQ(get("site/index.html"), "mine");
}

class DiffRevisionTest : public GitTest {};

TEST_F(DiffRevisionTest, ARevisionIsDrawnWithTheFilesOfTheWorkingTree) {
    const fs::path textures = WRINKLE_SOURCE_DIR "/graphs/textures";
    put("in/map.png", bytes_of(textures / "rivets_normal.png"));
    const std::string graph = R"({"wrinkle": 1, "nodes": {
  "map": { "type": "tangent_normal_map", "in": { "image": "map.png" } },
  "less": { "type": "gradient_scale", "in": { "gradient": { "from": "map.gradient" }, "amount": 1 } },
  "end": { "type": "resolve", "in": { "gradient": { "from": "less.gradient" } } } },
  "outputs": { "normal": { "from": "end.normal" } } }
)";
    put("in/g.json", graph);
    commit("graph");
    put("in/g.json", std::string(graph).replace(graph.find("\"amount\": 1"), 11, "\"amount\": 2"));
    const Ran ran = wrinkle({"diff", "HEAD:in/g.json", "in/g.json", "--render"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_EQ(ran.err, "");
    EXPECT_TRUE(says(ran.out, "in/g.normals/render: degrees "));
    put("in/map.png", bytes_of(textures / "weave_normal.png"));
    const Ran other = wrinkle({"diff", "HEAD:in/g.json", "in/g.json", "--render"});
    EXPECT_EQ(other.code, 1);
    EXPECT_TRUE(says(other.err, "differ from those of HEAD: in/map.png"));
}

}  // namespace
}  // namespace wrinkle::test
