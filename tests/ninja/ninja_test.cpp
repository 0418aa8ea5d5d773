// Tests of dependency files, restat and the cache with Ninja. The steps that Ninja prints show the
// commands that ran.
#include <unistd.h>

#include <algorithm>
#include <cstdlib>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

using Names = std::vector<std::string>;

class NinjaTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        program = NINJA;
    }

    // Returns the outputs that were built, sorted; the complete log if Ninja fails.
    Names built(const Names& targets = {}) const {
        Names args{"--verbose", "-C", folder.string()};
        args.insert(args.end(), targets.begin(), targets.end());
        const Ran ran = ninja(args);
        if (ran.code != 0) return {ran.out};
        Names made;
        for (size_t at = ran.out.find(" -o "); at != ran.out.npos; at = ran.out.find(" -o ", at)) {
            at += 4;
            made.push_back(ran.out.substr(at, ran.out.find_first_of(" \n", at) - at));
        }
        std::sort(made.begin(), made.end());
        return made;
    }

    Ran ninja(const Names& args) const {
        return run(args, "", {"PATH=" WRINKLE_BINARY_DIR "/bin:" + std::string(getenv("PATH"))});
    }

    // Ninja detects a change only by the modification time, which has steps of some milliseconds.
    void change(const std::string& name, const std::string& text) const {
        usleep(20'000);
        put(name, text);
    }
    void touch(const std::string& name) const { change(name, get(name)); }

    // Writes graphs with every kind of dependency, and a step that depends on the generated
    // sources.
    void project(const std::string& flags = "") const {
        put("inner.json", tilt_graph("0.5"));
        put("uses.json", R"({"wrinkle": 1, "nodes": {"sub": {"type": "graph:inner.json"}},
            "outputs": {"normal": {"from": "sub.normal"}}})");
        put("alone.json", tilt_graph("0.25"));
        put("map.png", "");
        put("image.json", R"({"wrinkle": 1, "nodes": {
            "map": {"type": "image", "in": {"image": "map.png"}}},
            "outputs": {"color": {"from": "map.color"}}})");
        put("build.ninja",
            "rule glsl\n  command = wrinkle compile $in -o $out -MD -MF $out.d " + flags +
                "\n  depfile = $out.d\n  deps = gcc\n  restat = 1\n"
                "rule pack\n  command = cat $in > $out; : -o $out\n"
                "build uses.glsl: glsl uses.json\nbuild alone.glsl: glsl alone.json\n"
                "build image.glsl: glsl image.json\nbuild pack: pack uses.glsl alone.glsl\n");
    }
    const Names everything{"alone.glsl", "image.glsl", "pack", "uses.glsl"};
};

TEST_F(NinjaTest, BuildsWhatChangedAndNothingElse) {
    project();
    EXPECT_EQ(built(), everything);
    EXPECT_EQ(built(), Names{});
    change("alone.json", tilt_graph("0.125"));
    EXPECT_EQ(built(), (Names{"alone.glsl", "pack"}));
    EXPECT_EQ(built(), Names{});
    change("inner.json", tilt_graph("0.125"));
    EXPECT_EQ(built(), (Names{"pack", "uses.glsl"}));
    EXPECT_EQ(built(), Names{});
}

TEST_F(NinjaTest, EqualTextsStopTheBuildThere) {
    project();
    built();
    touch("alone.json");
    EXPECT_EQ(built(), Names{"alone.glsl"}) << "and pack is not made again";
    EXPECT_EQ(built(), Names{});
    touch("map.png");
    EXPECT_EQ(built(), Names{"image.glsl"});
    EXPECT_EQ(built(), Names{});
}

TEST_F(NinjaTest, ASubgraphThatDisappearsIsSaidAndKeepsTheOldText) {
    project();
    built();
    const std::string before = get("uses.glsl");
    fs::remove(folder / "inner.json");
    const Ran ran = ninja({"-C", folder.string(), "-k", "0"});
    EXPECT_NE(ran.code, 0);
    EXPECT_TRUE(says(ran.out, "uses.json:1:"));
    EXPECT_TRUE(says(ran.out, "inner.json"));
    EXPECT_EQ(get("uses.glsl"), before);
    change("inner.json", tilt_graph("0.5"));
    EXPECT_EQ(built(), Names{"uses.glsl"});
}

TEST_F(NinjaTest, OneBadGraphAmongManyLeavesTheOthersBuilt) {
    project();
    put("alone.json", "{");
    EXPECT_NE(ninja({"-C", folder.string(), "-k", "0"}).code, 0);
    EXPECT_TRUE(exists("uses.glsl"));
    EXPECT_TRUE(exists("image.glsl"));
    EXPECT_FALSE(exists("alone.glsl"));
    EXPECT_FALSE(exists("pack"));
    change("alone.json", tilt_graph());
    EXPECT_EQ(built(), (Names{"alone.glsl", "pack"}));
}

// A hit must write the dependency file; otherwise the next build misses the sub-graph.
TEST_F(NinjaTest, TheCacheChangesNothingButTime) {
    project("--cache cache");
    EXPECT_EQ(built(), everything);
    const std::string before = get("pack");
    for (const char* name : {"uses.glsl", "alone.glsl", "image.glsl", "pack"})
        fs::remove(folder / name);
    fs::remove(folder / ".ninja_deps");
    EXPECT_EQ(built(), everything);
    EXPECT_EQ(get("pack"), before);
    change("inner.json", tilt_graph("0.125"));
    EXPECT_EQ(built(), (Names{"pack", "uses.glsl"}));
    EXPECT_NE(get("pack"), before);
    change("inner.json", tilt_graph("0.5"));
    EXPECT_EQ(built(), (Names{"pack", "uses.glsl"}));
    EXPECT_EQ(get("pack"), before);
}

TEST_F(NinjaTest, OneCallMayMakeMany) {
    project();
    put("build.ninja",
        "rule all\n  command = wrinkle compile $in -o out -MD -MP\n  depfile = out.d\n"
        "  deps = gcc\n  restat = 1\n"
        "build out/uses.glsl out/alone.glsl: all uses.json alone.json\n");
    EXPECT_EQ(built(), Names{"out"});
    EXPECT_EQ(built(), Names{});
    touch("inner.json");
    EXPECT_EQ(built(), Names{"out"});
    EXPECT_EQ(built(), Names{});
}

class SamplesTest : public NinjaTest {
protected:
    void SetUp() override {
        NinjaTest::SetUp();
        fs::copy(fs::path(WRINKLE_SOURCE_DIR) / "graphs", folder / "graphs",
                 fs::copy_options::recursive);
    }
    Names built_samples() const {
        Names made = built({"-C", "graphs"});
        for (std::string& name : made)
            name = fs::path(name).filename().string();
        return made;
    }
};

TEST_F(SamplesTest, AreAllListedAndFollowTheirGraphs) {
    Names all;
    for (const auto& each : fs::directory_iterator(folder / "graphs"))
        if (const std::string name = each.path().filename().string();
            name.ends_with(".json") && !name.ends_with(".test.json"))
            all.push_back(each.path().stem().string() + ".glsl");
    std::sort(all.begin(), all.end());
    EXPECT_EQ(built_samples(), all);
    EXPECT_EQ(built_samples(), Names{});
    touch("graphs/woven_strap.json");
    EXPECT_EQ(built_samples(), Names{"woven_strap.glsl"});
    EXPECT_EQ(built_samples(), Names{});
}

}  // namespace
}  // namespace wrinkle::test
