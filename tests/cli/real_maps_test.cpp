// Maps of the real world, where a folder of them stands beside the checkout: ../shared/data or
// WRINKLE_DATA. Skipped without. Nothing of it is copied into the project.
#include <cstdlib>

#include "cli/support.h"

namespace wrinkle::test {
namespace {

fs::path data_folder() {
    const char* named = std::getenv("WRINKLE_DATA");
    return named ? fs::path(named) : fs::path(WRINKLE_SOURCE_DIR) / "../shared/data";
}

class RealMaps : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        if (!fs::exists(data_folder() / "LICENSES.md")) GTEST_SKIP() << "no folder of real maps";
        for (const char* name : {"Bricks102_1K-JPG_NormalGL.jpg", "Bricks102_1K-JPG_NormalDX.jpg",
                                 "jacksboro_dem_metres.pfm", "rosewood_veneer1_nor_gl_1k.png"})
            fs::create_symlink(fs::canonical(data_folder() / name), folder / name);
    }

    // Mean angle between the outputs `normal` and `other` over a sphere, in degrees.
    double mean_angle(const std::string& green) const {
        put("both.json", R"({"wrinkle": 1, "nodes": {
          "tile": {"type": "uv_transform", "in": {"scale": [4, 4]}},
          "gl": {"type": "tangent_normal_map", "in": {"uv": {"from": "tile.uv"},
            "image": "Bricks102_1K-JPG_NormalGL.jpg"}},
          "dx": {"type": "tangent_normal_map", "in": {"uv": {"from": "tile.uv"},
            "image": {"file": "Bricks102_1K-JPG_NormalDX.jpg", "encoding": ")" +
                             green + R"("}}},
          "a": {"type": "resolve", "in": {"gradient": {"from": "gl.gradient"}}},
          "b": {"type": "resolve", "in": {"gradient": {"from": "dx.gradient"}}}},
          "outputs": {"normal": {"from": "a.normal"}, "other": {"from": "b.normal"}}})");
        const Ran ran = run({"render", "both.json", "-o", "both.png", "--view", "difference",
                             "--against", "other", "--size", "256x256", "--root", "/"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        const size_t at = ran.out.find("mean ");
        return at == std::string::npos ? -1 : std::strtod(ran.out.c_str() + at + 5, nullptr);
    }
};

// One surface in both conventions: the same normals when the green channel is named rightly (8-bit
// JPEG noise remains), far apart when it is not.
TEST_F(RealMaps, BothGreenConventionsGiveOneSurface) {
    EXPECT_LT(mean_angle("normal_dx"), 0.5);
    EXPECT_GT(mean_angle("normal_gl"), 3.0);
}

TEST_F(RealMaps, ATerrainInMetresAndASixteenBitWoodRender) {
    put("terrain.json", R"({"wrinkle": 1, "nodes": {
      "land": {"type": "height_map", "in": {"amplitude": 0.0003, "midlevel": 600,
        "image": {"file": "jacksboro_dem_metres.pfm", "wrap": "clamp"}}},
      "wood": {"type": "tangent_normal_map", "in": {"image": "rosewood_veneer1_nor_gl_1k.png"}},
      "sum": {"type": "gradient_add", "in": {"a": {"from": "land.height"},
        "b": {"from": "wood.gradient"}}}},
      "outputs": {"normal": {"from": "sum.gradient"}}})");
    const Ran ran = run({"render", "terrain.json", "-o", "terrain.png", "--mesh", "plane", "--view",
                         "difference", "--size", "128x128", "--root", "/"});
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_TRUE(exists("terrain.png"));
    EXPECT_TRUE(says(ran.out, "mean "));
}

}  // namespace
}  // namespace wrinkle::test
