// Limits of the project's own regression cases: seeded changes of a sample exceed them.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

class OwnCasesTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        const fs::path samples = WRINKLE_SOURCE_DIR "/graphs";
        for (const char* file : {"base_and_detail.json", "base_and_detail.test.json",
                                 "golden/base_and_detail.png", "golden/base_and_detail.glsl",
                                 "textures/rivets_normal.png", "textures/weave_normal.png"})
            put(file, bytes_of(samples / file));
    }

    void change(const std::string& from, const std::string& to) const {
        std::string graph = get("base_and_detail.json");
        const size_t at = graph.find(from);
        ASSERT_NE(at, graph.npos);
        put("base_and_detail.json", graph.replace(at, from.size(), to));
    }
};

TEST_F(OwnCasesTest, ADetailThatIsAFifthStrongerExceedsTheAngleOfItsImage) {
    change("\"amount\": 0.5", "\"amount\": 0.6");
    const Ran ran = run({"test", "base_and_detail.test.json"}, "", {"CI="});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "FAIL base_and_detail/render: the image differs by 0.4"));
}

TEST_F(OwnCasesTest, OneMoreNodeExceedsTheBudget) {
    change("\"tile.uv\"", "\"turned.uv\"");
    change("\"softer\"",
           R"("turned": { "type": "uv_transform", "in": { "uv": { "from": "tile.uv" },
      "rotation": 0.2 } },
    "softer")");
    const Ran ran = run({"test", "base_and_detail.test.json"}, "", {"CI="});
    EXPECT_EQ(ran.code, 1);
    EXPECT_TRUE(says(ran.out, "FAIL base_and_detail/budget: alu is "));
}

}  // namespace
}  // namespace wrinkle::test
