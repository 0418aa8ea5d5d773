// Tests of missing resources and large inputs: one message each, with limits on time and memory.
#include <sys/stat.h>

#include <algorithm>
#include <thread>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using LimitsTest = CliTest;

// A graph with n199 = (uv0.x + 1)^(2^199) by repeated squaring.
std::string chain_graph() {
    std::string nodes = R"("split": {"type": "separate_vec2", "in": {"vector": {"from":
        "surface.uv0"}}}, "n0": {"type": "add", "in": {"a": {"from": "split.x"}, "b": 1}})";
    for (int i = 1; i < 200; ++i) {
        const std::string before = "{\"from\": \"n" + std::to_string(i - 1) + ".result\"}";
        nodes += ", \"n" + std::to_string(i) +
                 "\": {\"type\": \"multiply\", \"in\": {\"a\": " + before + ", \"b\": " + before +
                 "}}";
    }
    return "{\"wrinkle\": 1, \"nodes\": {" + nodes +
           "}, \"outputs\": {\"value\": {\"from\": \"n199.result\"}}}";
}

// `n` nodes of `type` in a row; each reads the previous one, the first reads a wave of uv0.
std::string row_of(const std::string& type, const std::string& in, const std::string& out, int n) {
    std::string nodes = R"("wave": {"type": "waves"})", from = "wave.height";
    for (int i = 0; i < n; ++i) {
        const std::string id = "n" + std::to_string(i);
        nodes += ", \"" + id + "\": {\"type\": \"" + type + "\", \"in\": {\"" + in +
                 "\": {\"from\": \"" + from + "\"}}}";
        from = id + "." + out;
    }
    return "{\"wrinkle\": 1, \"nodes\": {" + nodes + "}, \"outputs\": {\"value\": {\"from\": \"" +
           from + "\"}}}";
}
std::string tilts(int n) {
    return row_of("gradient_tilt", "gradient", "tilt", n);
}

std::string points(const std::string& point, size_t count) {
    std::string text = "[" + point;
    for (size_t i = 1; i < count; ++i)
        text += "," + point;
    return text + "]";
}

TEST_F(LimitsTest, OutOfMemoryIsOneSentence) {
    LIMITED_MEMORY;
    put("g.json", ramp_graph());
    put("p.json", points("{}", 2'000'000));
    memory = 100'000'000;
    const Ran ran = run({"eval", "g.json", "--at", "@p.json"});
    EXPECT_EQ(ran.code, 3);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(ran.err, "wrinkle: error: out of memory\n");
}

TEST_F(LimitsTest, ASweepTakesTheMemoryOfOneRun) {
    LIMITED_MEMORY;
    put("g.json", chain_graph());
    memory = 60'000'000;
    const Ran ran = run({"eval", "g.json", "--at", R"({"uv0": [0, 0]})", "--set", "n0.b=0:1:2000"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(parsed(ran.out).find("runs").size(), 2000u);
}

TEST_F(LimitsTest, ARowOfSlopesOfSlopesIsRefusedAtANode) {
    LIMITED_MEMORY;
    memory = 1'000'000'000;
    for (const int n : {12, 20, 60}) {
        put("g.json", tilts(n));
        const Ran ran = run({"compile", "g.json", "-o", "g.glsl"});
        EXPECT_EQ(ran.code, 1) << n << ": " << ran.err;
        EXPECT_TRUE(says(ran.err, ": error: node 'n")) << n;
        EXPECT_TRUE(says(ran.err, "the graph becomes more than")) << n;
        EXPECT_TRUE(says(ran.err, "bake that into an image")) << n;
        EXPECT_FALSE(exists("g.glsl")) << n;
    }
    for (const std::vector<std::string>& rest :
         {std::vector<std::string>{"check", "g.json"},
          std::vector<std::string>{"eval", "g.json", "--at", "{}"},
          std::vector<std::string>{"bake", "g.json", "--mesh", "plane", "-o", "g.png"}}) {
        const Ran ran = run(rest);
        EXPECT_EQ(ran.code, 1) << rest[0];
        EXPECT_TRUE(says(ran.err, "node 'n")) << rest[0];
        EXPECT_TRUE(says(ran.err, "the graph becomes more than 1000000 values")) << rest[0];
    }
}

// Each relief is a function of the one before, so the text is short; to run it would take too long.
TEST_F(LimitsTest, ARowOfReliefsInReliefsIsATextButDoesNotRun) {
    LIMITED_MEMORY;
    memory = 1'000'000'000;
    for (const int n : {8, 40}) {
        put("g.json", row_of("parallax_occlusion", "height", "height", n));
        const Ran ran = run({"compile", "g.json"});
        EXPECT_EQ(ran.code, 0) << n << ": " << ran.err;
        EXPECT_LT(ran.out.size(), 20'000U * static_cast<unsigned>(n)) << n;
    }
    const Ran ran = run({"eval", "g.json", "--at", "{}"});
    EXPECT_EQ(ran.code, 1) << ran.err;
    EXPECT_TRUE(says(ran.err, ": error: node 'n"));
    EXPECT_TRUE(says(ran.err, "eval would make more than 4000000 operations"));
}

TEST_F(LimitsTest, AVariableRaisesOrLowersALimit) {
    put("g.json", tilts(4));
    EXPECT_EQ(run({"compile", "g.json"}).code, 0);
    const Ran values = run({"compile", "g.json"}, "", {"WRINKLE_GRAPH_MAX_VALUES=300"});
    EXPECT_EQ(values.code, 1);
    EXPECT_TRUE(says(values.err, "the graph becomes more than 300 values"));
    EXPECT_TRUE(says(values.err, "WRINKLE_GRAPH_MAX_VALUES above 300"));
    const Ran text = run({"compile", "g.json"}, "", {"WRINKLE_TEXT_MAX_BYTES=3000"});
    EXPECT_EQ(text.code, 1);
    EXPECT_EQ(text.out, "");
    EXPECT_TRUE(says(text.err, "the graph becomes more than 3000 bytes of text"));
    const Ran wrong = run({"compile", "g.json"}, "", {"WRINKLE_TEXT_MAX_BYTES=many"});
    EXPECT_EQ(wrong.code, 1);
    EXPECT_TRUE(says(wrong.err, "environment variable WRINKLE_TEXT_MAX_BYTES is 'many'"));
}

// With any limit, the output is either the complete source or empty with the one message.
TEST_F(LimitsTest, AnyLimitOfValuesGivesTheWholeTextOrTheSentence) {
    put("g.json", row_of("parallax_occlusion", "height", "height", 1));
    const std::string whole = run({"compile", "g.json"}).out;
    ASSERT_NE(whole, "");
    int refused = 0, made = 0;
    for (int most = 1; most < 4000; most += most / 8 + 1) {
        const Ran ran =
            run({"compile", "g.json"}, "", {"WRINKLE_GRAPH_MAX_VALUES=" + std::to_string(most)});
        made += ran.code == 0;
        refused += ran.code == 1;
        EXPECT_EQ(ran.out, ran.code == 0 ? whole : "") << most;
        if (ran.code == 0) continue;
        EXPECT_EQ(ran.code, 1) << most << ran.err;
        EXPECT_TRUE(says(ran.err, "becomes more than " + std::to_string(most) + " values"));
    }
    EXPECT_GT(refused, 10);
    EXPECT_GT(made, 3);
}

TEST_F(LimitsTest, GraphsMadeAtTheSameTimeAreRefusedAsAlone) {
    put("small.json", ramp_graph());
    put("large.json", tilts(5));
    const std::vector<std::string> limit = {"WRINKLE_GRAPH_MAX_VALUES=12000"};
    EXPECT_EQ(run({"compile", "large.json"}, "", {"WRINKLE_GRAPH_MAX_VALUES=3000"}).code, 1);
    const Ran alone = run({"compile", "large.json"}, "", limit);
    ASSERT_EQ(alone.code, 0) << "more than a quarter, and less than all" << alone.err;
    put("large2.json", tilts(5));
    put("small2.json", ramp_graph());
    const Ran many = run(
        {"compile", "small.json", "large.json", "large2.json", "small2.json", "-j4", "-o", "out"},
        "", limit);
    EXPECT_EQ(many.code, 0) << many.err;
    EXPECT_EQ(many.err, "");
    EXPECT_NE(get("out/large.glsl"), "");
    EXPECT_NE(get("out/large2.glsl"), "");
}

TEST_F(LimitsTest, ImagesOfOneGraphShareTheirMemory) {
    const std::string pixels(size_t{64} * 64, '\x7f');
    put("a.pgm", "P5 64 64 255\n" + pixels);
    put("b.pgm", "P5 64 64 255\n" + pixels);
    put("g.json", R"({"wrinkle": 1, "nodes": {"a": {"type": "height_map", "in": {"image": "a.pgm"}},
        "b": {"type": "height_map", "in": {"image": "b.pgm"}},
        "sum": {"type": "height_add",
                "in": {"a": {"from": "a.height"}, "b": {"from": "b.height"}}}},
        "outputs": {"height": {"from": "sum.height"}}})");
    const std::vector<std::string> eval = {
        "eval", "g.json", "--at",
        R"({"uv0": [0, 0], "dx": {"uv0": [0, 0]}, "dy": {"uv0": [0, 0]}})"};
    constexpr int one = 64 * 64 * 4 / 3 * 4 + 64 * 64 * 4;
    const Ran both = run(eval, "", {"WRINKLE_IMAGES_MAX_BYTES=" + std::to_string(2 * one)});
    EXPECT_EQ(both.code, 0) << both.err;
    const Ran less = run(eval, "", {"WRINKLE_IMAGES_MAX_BYTES=" + std::to_string(2 * one - 1)});
    EXPECT_EQ(less.code, 1);
    EXPECT_EQ(less.out, "");
    EXPECT_TRUE(says(less.err, "node 'b'")) << "the first fits";
    EXPECT_TRUE(
        says(less.err, "for all images of the graph " + std::to_string(one - 1) + " are left"));
    EXPECT_TRUE(says(less.err, "WRINKLE_IMAGES_MAX_BYTES=" + std::to_string(2 * one)));
}

TEST_F(LimitsTest, ManyBadPointsAreCounted) {
    put("g.json", ramp_graph());
    put("p.json", points("{\"normal\": [0, 0, 1]}", 60'000));
    const auto start = std::chrono::steady_clock::now();
    const Ran ran = run({"eval", "g.json", "--at", "@p.json"});
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "point 999 lacks 'uv0'"));
    EXPECT_TRUE(ran.err.ends_with("and 59000 more problems\n"));
}

TEST_F(LimitsTest, NoFolderForTemporaryFilesIsOneSentence) {
    put("g.json", tilt_graph());
    const Ran ran = run({"render", "g.json", "-o", "-", "--size", "8x8"}, "",
                        {"TMPDIR=" + (folder / "none").string()});
    EXPECT_EQ(ran.code, 3);
    EXPECT_EQ(ran.out, "");
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
}

TEST_F(LimitsTest, AFolderThatCannotBeSearchedIsAnError) {
    put("x/a.json", tilt_graph());
    put("x/a.test.json", R"({"points": [{"normal": [0, 0, 1]}],
        "expect": [{"normal": [-0.6, 0, 0.8]}]})");
    put("x/locked/b.test.json", "{}");
    fs::permissions(folder / "x/locked", fs::perms::none);
    fs::permissions(folder, fs::perms::all);
    unprivileged = true;
    if (run({"--version"}).code != 0) GTEST_SKIP() << "capabilities cannot be dropped";
    const Ran ran = run({"test", "x"});
    EXPECT_NE(ran.code, 0) << ran.out;
    EXPECT_TRUE(says(ran.err, "x/locked: cannot be searched"));
    fs::permissions(folder / "x/locked", fs::perms::owner_all);
}

// A pipe that is written at one end and read at the other.
TEST_F(LimitsTest, APipeTakesAText) {
    put("g.json", tilt_graph());
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::string text;
    std::thread reader([&] { text = get("pipe"); });
    const Ran ran = run({"compile", "g.json", "--name", "g", "-o", "pipe"});
    reader.join();
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_EQ(text, run({"compile", "g.json"}).out);
}

}  // namespace
}  // namespace wrinkle::test
