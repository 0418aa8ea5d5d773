// Tests of graphs/bake with Ninja: which bakes are repeated after a change or a killed shard.
#include <unistd.h>

#include "cli/killed_shard.h"

namespace wrinkle::test {
namespace {

class BakedSamplesTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        fs::copy(WRINKLE_SOURCE_DIR "/graphs", folder / "graphs", fs::copy_options::recursive);
        path_ = path_with_killer(folder, "none");
        // Halves the size of the example's bakes to save time.
        std::string rules = get("graphs/bake/build.ninja");
        const size_t at = rules.find("--size 1024");
        ASSERT_NE(at, rules.npos);
        put("graphs/bake/build.ninja", rules.replace(at, 11, "--size 512"));
    }

    Ran ninja() {
        program = NINJA;
        const Ran ran = run({"-C", "graphs/bake"}, "", {path_});
        program = WRINKLE_BINARY_DIR "/bin/wrinkle";
        return ran;
    }
    // Returns the logged calls of a successful build.
    std::string calls() {
        const Ran ran = ninja();
        EXPECT_EQ(ran.code, 0) << ran.out;
        return exists("killer/calls") ? take_calls(folder) : "";
    }
    void kill_once(const std::string& shard) { path_ = path_with_killer(folder, shard); }
    // Ninja detects a change only by the modification time, which has steps of some milliseconds.
    void change(const std::string& name, const std::string& bytes) {
        usleep(20'000);
        put(name, bytes);
    }
    void expect_map(const std::string& sample, const std::string& mesh) {
        const Ran ran = run({"bake", "graphs/" + sample + ".json", "--mesh", mesh, "-o",
                             "alone.png", "--size", "512"});
        ASSERT_EQ(ran.code, 0) << ran.err;
        EXPECT_TRUE(get("alone.png") == get("build/bake/" + sample + ".png")) << sample;
    }

private:
    std::string path_;
};

TEST_F(BakedSamplesTest, AreBakedAgainWhenWhatTheyReadChanged) {
    const std::string all = calls();
    EXPECT_EQ(times(all, "--shard"), 12U);
    EXPECT_EQ(times(all, "--merge"), 3U);
    for (const auto& [sample, mesh] :
         {std::pair("noise_rock", "teapot"), {"plain_height", "cube"}, {"woven_strap", "torus"}})
        expect_map(sample, mesh);
    EXPECT_EQ(calls(), "");

    const std::string before = get("build/bake/woven_strap.png");
    std::string graph = get("graphs/woven_strap.json");
    const size_t at = graph.find("\"scale\": [");
    ASSERT_NE(at, graph.npos);
    change("graphs/woven_strap.json", graph.insert(at + 10, "1"));
    const std::string one = calls();
    EXPECT_EQ(times(one, "--shard"), 4U) << one;
    EXPECT_EQ(times(one, "bake ../woven_strap.json"), 4U) << one;
    EXPECT_EQ(times(one, "--merge"), 1U) << one;
    EXPECT_NE(get("build/bake/woven_strap.png"), before);
    expect_map("woven_strap", "torus");
    EXPECT_EQ(calls(), "");

    change("graphs/textures/rivets_normal.png", get("graphs/textures/rivets_normal.png"));
    const std::string rivets = calls();
    EXPECT_EQ(times(rivets, "bake ../woven_strap.json"), 4U) << rivets;
    EXPECT_EQ(times(rivets, "--shard"), 4U) << rivets;
    EXPECT_EQ(calls(), "");
}

// The samples were baked before; their older files do not count as the killed shard's result.
TEST_F(BakedSamplesTest, AKilledShardIsBakedAgainAlone) {
    EXPECT_EQ(times(calls(), "--shard"), 12U);
    change("graphs/noise_rock.json", get("graphs/noise_rock.json") + "\n");
    kill_once("2/4");
    const Ran killed = ninja();
    EXPECT_NE(killed.code, 0);
    EXPECT_TRUE(says(killed.out, "FAILED: ../../build/bake/noise_rock.parts/2/done"));
    const std::string before = take_calls(folder), again = calls();
    EXPECT_EQ(times(before, "--merge"), 0U) << before;
    EXPECT_EQ(times(again, "--merge"), 1U) << again;
    for (const char* shard : {"1/4", "2/4", "3/4", "4/4"})
        EXPECT_EQ(times(before + again, std::string("--shard ") + shard), shard[0] == '2' ? 2U : 1U)
            << before << again;
    expect_map("noise_rock", "teapot");
    EXPECT_EQ(calls(), "");
}

}  // namespace
}  // namespace wrinkle::test
