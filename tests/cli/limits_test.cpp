// What the machine does not give, and inputs that are large: one sentence, in time and in memory.
#include <sys/stat.h>

#include <algorithm>
#include <thread>

#include "cli/support.h"

#if defined(__SANITIZE_ADDRESS__)
#define LIMITED_MEMORY GTEST_SKIP() << "the sanitizer needs all of the address space"
#else
#define LIMITED_MEMORY static_cast<void>(0)
#endif

namespace wrinkle::test {
namespace {

using LimitsTest = CliTest;

// n199 = (uv0.x + 1)^(2^199) by repeated squaring.
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

std::string points(const std::string& point, size_t count) {
    std::string text = "[" + point;
    for (size_t i = 1; i < count; ++i)
        text += "," + point;
    return text + "]";
}

TEST_F(LimitsTest, OutOfMemoryIsOneSentence) {
    LIMITED_MEMORY;
    put("g.json", ramp_graph());
    put("p.json", points("{}", 200'000));
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
    as_nobody = true;
    if (run({"--version"}).code != 0) GTEST_SKIP() << "nobody may not run the program";
    const Ran ran = run({"test", "x"});
    EXPECT_NE(ran.code, 0) << ran.out;
    EXPECT_TRUE(says(ran.err, "x/locked: cannot be searched"));
    fs::permissions(folder / "x/locked", fs::perms::owner_all);
}

// Written to from one end, read at the other.
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
