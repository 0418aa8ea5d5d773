// Tests of the warning for a map with the scale `unit` that is read with uvs projected from the
// position.
#include "cli/support.h"

namespace wrinkle::test {
namespace {

class ProjectedTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/textures/weave_normal.png", folder / "weave.png");
    }
    // Returns the messages for a bump map with these inputs.
    std::string said(const std::string& inputs, const std::string& command = "check") const {
        put("g.json", R"({"wrinkle": 1, "nodes": {
            "side": {"type": "planar_uv"},
            "moved": {"type": "uv_transform", "in": {"uv": {"from": "side.uv"}}},
            "bump": {"type": "tangent_normal_map", "in": {"image": "weave.png")" +
                          inputs + R"(}},
            "end": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}},
            "back": {"type": "tangent_space_normal", "in": {"uv": {"from": "side.uv"},
                     "normal": {"from": "end.normal"}}}},
            "outputs": {"normal": {"from": "end.normal"}, "back": {"from": "back.normal"}}})");
        const Ran ran = run({command, "g.json"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        return ran.err;
    }
};

TEST_F(ProjectedTest, AMapWithoutAScaleIsWarnedOfAtItsNode) {
    const std::string uv = R"(, "uv": {"from": "side.uv"})";
    for (const char* command : {"check", "compile"}) {
        const std::string warned = said(uv, command);
        EXPECT_TRUE(
            says(warned, "g.json:4:13: warning: node 'bump': 'side' projects the position"));
        EXPECT_TRUE(says(warned, R"("scale": "surface" makes it that bump)"));
        EXPECT_EQ(warned.find("warning", warned.find("warning") + 1), warned.npos) << warned;
    }
    EXPECT_TRUE(says(said(R"(, "uv": {"from": "moved.uv"})"), "warning: node 'bump': 'side'"));
}

TEST_F(ProjectedTest, AScaleThatIsWrittenAndAUvOfTheMeshAreFine) {
    const std::string uv = R"(, "uv": {"from": "side.uv"})";
    EXPECT_EQ(said(uv + R"(, "scale": "unit")"), "");
    EXPECT_EQ(said(uv + R"(, "scale": "surface")"), "");
    EXPECT_EQ(said(""), "");
    EXPECT_EQ(said(R"(, "uv": {"from": "surface.uv1"})"), "");
}

}  // namespace
}  // namespace wrinkle::test
