// Tests with real maps from ../shared/data or WRINKLE_DATA; skipped without that folder. No part of
// the data is copied into the project.
#include <cstdlib>

#include "cli/support.h"
#include "image/load.h"

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
                                 "Bricks102_1K-JPG_Displacement.jpg", "jacksboro_dem_metres.pfm",
                                 "jacksboro_dem_16bit.png", "rosewood_veneer1_nor_gl_1k.png",
                                 "spot_normal_object.png", "spot_normal_tangent_8bit.png"})
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

// One surface in both green conventions: the normals agree if the green channel is named correctly
// (8-bit JPEG noise remains) and differ widely if not.
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

TEST_F(RealMaps, LintKnowsEach) {
    const std::pair<const char*, const char*> looks[] = {
        {"Bricks102_1K-JPG_NormalGL.jpg", "normal_gl"},
        {"Bricks102_1K-JPG_NormalDX.jpg", "normal_dx"},
        {"Bricks102_1K-JPG_Displacement.jpg", "height"},
        {"rosewood_veneer1_nor_gl_1k.png", "normal_gl"},
        {"jacksboro_dem_16bit.png", "height"},
        {"jacksboro_dem_metres.pfm", "height"},
        {"spot_normal_object.png", "normal_object"},
        {"spot_normal_tangent_8bit.png", "normal_gl"}};
    for (const auto& [file, look] : looks) {
        const bool terrain = std::string_view(file).starts_with("jacksboro");
        const Ran ran = run({"lint", file});
        EXPECT_TRUE(says(ran.out, std::string(file) + ": " + look + ":"));
        EXPECT_EQ(ran.code, terrain ? 1 : 0) << ran.out;  // the terrain does not tile
        EXPECT_EQ(run({"lint", file, "--wrap", "clamp"}).code, 0) << ran.out;
    }
}

// Heights in metres, cells of 3 arc seconds (dx and dy of jacksboro_fault_dem.npz in Debian's
// python3-matplotlib; 36.45 to 36.73 degrees north, 111,195 m per degree): 74.4 by 92.7 metres.
// Slope times cell size, summed along a row, is the rise between its ends, weighted over the
// filter's three rows; columns likewise.
TEST_F(RealMaps, TheTerrainHasTheSlopesOfItsCells) {
    const double cell[] = {74.4, 92.7};
    EXPECT_EQ(run({"convert", "jacksboro_dem_metres.pfm", "--from", "height", "-o", "d.exr", "--to",
                   "derivative", "--type", "float", "--texel", "74.4,92.7"})
                  .code,
              0);
    const auto values = [&](const char* name) {
        Diagnostics diagnostics;
        const auto image = load_image(folder / name, diagnostics);
        EXPECT_TRUE(image) << to_text(diagnostics);
        return image ? image->data : std::vector<float>();
    };
    const size_t w = 403, h = 344;
    const auto heights = values("jacksboro_dem_metres.pfm"), slopes = values("d.exr");
    ASSERT_EQ(heights.size(), w * h);
    ASSERT_EQ(slopes.size(), w * h * 2);
    const auto rise = [&](size_t place, size_t step, size_t last) {
        return (heights[place + last * step] + heights[place + (last - 1) * step] -
                heights[place + step] - heights[place]) /
               2.0;
    };
    for (const size_t axis : {size_t{0}, size_t{1}}) {
        const size_t step = axis ? w : 1, side = axis ? 1 : w;
        const size_t last = (axis ? h : w) - 1, lines = axis ? w : h;
        for (size_t line = 1; line + 1 < lines; ++line) {
            double sum = 0;
            for (size_t i = 1; i < last; ++i)
                sum += slopes[(line * side + i * step) * 2 + axis] * cell[axis];
            const double expected =
                (rise((line - 1) * side, step, last) + 2 * rise(line * side, step, last) +
                 rise((line + 1) * side, step, last)) /
                4;
            ASSERT_NEAR(sum, expected, 0.01) << axis << " " << line;
        }
    }
}

}  // namespace
}  // namespace wrinkle::test
