// Tests of the amplitude of a height map fitted to a normal map: both are made of one function, so
// the amplitude is known.
#include "import/relief.h"

#include <cmath>

#include "image/load.h"
#include "maps/support.h"
#include "support/files.h"

namespace wrinkle::textures {
namespace {
namespace fs = std::filesystem;

class Relief : public testing::Test {
protected:
    // Writes heights in [0, 1] and normals of `amplitude` texels times these heights.
    void make(uint32_t width, uint32_t height, double amplitude, PixelType type, bool green_down) {
        test::Waves waves{width, height, 1};
        Image heights = height_image(waves);
        for (float& value : heights.data)
            value = (value + 4) / 8;  // the waves lie within +-3.4
        waves.strength = amplitude / 8;
        Image normals = normal_image(waves);
        if (green_down)
            for (size_t i = 1; i < normals.data.size(); i += 3)
                normals.data[i] = 1 - normals.data[i];
        save(heights, "height.png", type);
        save(normals, "normal.png", type);
    }
    void save(const Image& image, const char* name, PixelType type) {
        WriterOptions options;
        options.type = type;
        EXPECT_TRUE(save_image(image, folder.path() / name, options, problems));
    }
    std::optional<double> fitted(maps::Green green = maps::Green::gl) {
        return fitted_relief(folder.path() / "height.png", folder.path() / "normal.png", green,
                             problems);
    }

    test::TemporaryFolder folder;
    Diagnostics problems;
};

TEST_F(Relief, IsTheAmplitudeInTexels) {
    for (const double amplitude : {2.0, 20.0}) {
        make(128, 96, amplitude, PixelType::u16, false);
        const auto found = fitted();
        ASSERT_TRUE(found) << to_text(problems);
        EXPECT_NEAR(*found / amplitude, 1, 0.02) << amplitude;
    }
}

// Means over squares of texels: a large image of 8 bits.
TEST_F(Relief, OfManyTexelsOf8BitsIsFitted) {
    make(2100, 700, 60, PixelType::u8, false);
    const auto found = fitted();
    ASSERT_TRUE(found) << to_text(problems);
    EXPECT_NEAR(*found / 60, 1, 0.05);
}

TEST_F(Relief, DependsOnTheDirectionOfGreen) {
    make(128, 96, 10, PixelType::u16, true);
    const auto down = fitted(maps::Green::dx);
    ASSERT_TRUE(down);
    EXPECT_NEAR(*down / 10, 1, 0.02);
    const auto up = fitted(maps::Green::gl);
    EXPECT_TRUE(!up || *up < 8) << *up;
}

TEST_F(Relief, IsAbsentWhereTheMapsDisagree) {
    make(64, 64, 10, PixelType::u16, false);
    save(make_image(64, 64, 1), "height.png", PixelType::u8);
    EXPECT_FALSE(fitted()) << "flat";
    Image inverted = height_image(test::Waves{64, 64, 1});
    for (float& value : inverted.data)
        value = (4 - value) / 8;
    save(inverted, "height.png", PixelType::u16);
    EXPECT_FALSE(fitted()) << "a depth map";
    make(32, 64, 10, PixelType::u16, false);
    save(make_image(64, 64, 1), "height.png", PixelType::u8);
    EXPECT_FALSE(fitted()) << "other sizes";
    save(make_image(1, 1, 1), "height.png", PixelType::u8);
    save(make_image(1, 1, 3), "normal.png", PixelType::u8);
    EXPECT_FALSE(fitted()) << "one texel";
    EXPECT_FALSE(problems.has_errors());
    folder.put("height.png", "no image");
    EXPECT_FALSE(fitted());
    EXPECT_TRUE(problems.has_errors());
}

TEST_F(Relief, StopsWhenTold) {
    make(64, 64, 10, PixelType::u16, false);
    EXPECT_FALSE(fitted_relief(folder.path() / "height.png", folder.path() / "normal.png",
                               maps::Green::gl, problems, [] { return true; }));
    EXPECT_FALSE(problems.has_errors());
}

}  // namespace
}  // namespace wrinkle::textures
