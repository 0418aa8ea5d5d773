// Tests of wrinkle test --filter and --changed-since, with a real Git.
#include "git/repository.h"

namespace wrinkle::test {
namespace {

class SelectionTest : public GitTest {
protected:
    void SetUp() override {
        GitTest::SetUp();
        put("t/flat.json", R"({"wrinkle": 1, "nodes": {
  "map": { "type": "tangent_normal_map", "in": { "image": "map.png" } },
  "end": { "type": "resolve", "in": { "gradient": { "from": "map.gradient" } } } },
  "outputs": { "normal": { "from": "end.normal" } } }
)");
        put("t/map.png", bytes_of(WRINKLE_SOURCE_DIR "/graphs/textures/rivets_normal.png"));
        put("t/flat.test.json", R"({"glsl": true})");
        put("t/ramp.json", ramp_graph());
        put("t/ramp.test.json", R"({"glsl": true,
  "cases": [{"name": "steep", "set": ["scaled.b=9"], "glsl": true}]})");
        put("t/deep/tilt.json", tilt_graph());
        put("t/deep/tilt.test.json", R"({"glsl": true})");
        EXPECT_EQ(test({"--update"}).code, 0);
        commit("cases");
    }

    // Runs all cases of `t`.
    Ran test(std::vector<std::string> words) {
        words.insert(words.begin(), {"test", "t"});
        return run(words, "", [] {
            auto all = environment();
            all.emplace_back("CI=");
            return all;
        }());
    }
    std::string since_head() { return test({"--changed-since", "HEAD"}).out; }
};

TEST_F(SelectionTest, FiltersSelectByPartOrPattern) {
    const std::vector<std::pair<std::vector<std::string>, int>> rows = {
        {{"t/"}, 4},      {{"ramp"}, 2},          {{"steep"}, 1},   {{"t/*"}, 4},
        {{"*/tilt"}, 1},  {{"t/ram?"}, 1},        {{"*.steep"}, 1}, {{"[tu]/ramp*"}, 2},
        {{"t/deep/"}, 1}, {{"steep", "tilt"}, 2},
    };
    for (const auto& [filters, count] : rows) {
        std::vector<std::string> words;
        for (const std::string& filter : filters)
            words.insert(words.end(), {"--filter", filter});
        EXPECT_EQ(test(words).out, std::to_string(count) + " passed, 0 failed\n") << filters[0];
    }
    const Ran none = test({"--filter", "Ramp"});
    EXPECT_EQ(none.code, 1);
    EXPECT_TRUE(says(none.err, "--filter Ramp: no case has such a name"));
    EXPECT_EQ(run({"test", "--filter", "ramp"}).code, 2);
}

TEST_F(SelectionTest, DeletedBaselinesAreThoseOfFilteredNames) {
    put("t/golden/ramp.old.glsl", "");
    EXPECT_TRUE(says(test({"--filter", "ramp"}).out, "DELETED t/golden/ramp.old.glsl"));
    EXPECT_EQ(test({"--filter", "flat"}).out, "1 passed, 0 failed\n");
}

TEST_F(SelectionTest, EachKindOfFileSelectsItsCases) {
    EXPECT_EQ(since_head(), "0 passed, 0 failed\n");
    put("t/map.png", bytes_of(WRINKLE_SOURCE_DIR "/graphs/textures/weave_normal.png"));
    EXPECT_EQ(since_head(), "1 passed, 0 failed\n");
    put("t/deep/tilt.test.json", R"({ "glsl": true })");
    EXPECT_EQ(since_head(), "2 passed, 0 failed\n");
    put("t/golden/ramp.steep.glsl", "old");
    EXPECT_TRUE(says(since_head(), "FAIL t/ramp.steep/glsl"));
    EXPECT_TRUE(since_head().ends_with("\n2 passed, 1 failed\n"));
    put("t/ramp.json", ramp_graph("7"));
    EXPECT_TRUE(since_head().ends_with("\n2 passed, 2 failed\n"));
    commit("all");
    EXPECT_EQ(since_head(), "0 passed, 0 failed\n");
    EXPECT_TRUE(says(test({"--changed-since", "HEAD~1"}).out, "2 passed, 2 failed\n"));
    fs::remove(folder / "t/golden/flat.glsl");
    EXPECT_TRUE(says(since_head(), "NEW t/flat/glsl"));
}

TEST_F(SelectionTest, NewFilesAndLinksAreChanges) {
    put("t/next.json", tilt_graph("0.5"));
    put("t/next.test.json", R"({"points": [{"normal": [0, 0, 1]}]})");
    EXPECT_TRUE(since_head().ends_with("0 passed, 0 failed, 1 new\n"));
    put("t/real.png", bytes_of(folder / "t/map.png"));
    commit("next");
    fs::remove(folder / "t/map.png");
    fs::create_symlink("real.png", folder / "t/map.png");
    EXPECT_EQ(since_head(), "1 passed, 0 failed\n");
    folder /= "t";
    EXPECT_EQ(run({"test", ".", "--changed-since", "HEAD"}, "", {"CI="}).out,
              "1 passed, 0 failed\n");
}

TEST_F(SelectionTest, ARevisionThatGitDoesNotKnowIsAnError) {
    for (const char* name : {"none", "--output=x", "HEAD:t"}) {
        const Ran ran = test({"--changed-since=" + std::string(name)});
        EXPECT_EQ(ran.code, 1);
        EXPECT_TRUE(says(ran.err, std::string(name) + ": Git knows no such revision"));
    }
    EXPECT_FALSE(exists("x"));
    fs::remove_all(folder / ".git");
    const Ran ran =
        run({"test", "t", "--changed-since", "HEAD"}, "", {"GIT_CEILING_DIRECTORIES=/"});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.err, "not in a Git work tree"));
}

}  // namespace
}  // namespace wrinkle::test
