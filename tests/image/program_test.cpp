// Tests with processes: lookup of the image module, and equality of the textures that make_textures
// generates with those in the repository.
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "image/load.h"
#include "support.h"

namespace wrinkle::test {
namespace {

const fs::path committed = fs::path(WRINKLE_SOURCE_DIR) / "graphs/textures";

struct Ran {
    int code = -1;
    std::string output;  // stdout and stderr
};

Ran run(const std::string& command) {
    Ran ran;
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return ran;
    char buffer[4096];
    for (size_t count = 0; (count = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
        ran.output.append(buffer, count);
    const int status = pclose(pipe);
    ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return ran;
}

class ProgramTest : public ImageTest {
protected:
    // Copies a program into a folder without the image module; returns its command line, which
    // saves `file`.
    std::string stray_program(const std::string& file) const {
        fs::create_directories(folder / "bin");
        fs::copy_file(SAVE_IMAGE, folder / "bin/save_image");
        return (folder / "bin/save_image").string() + " " + (folder / file).string();
    }
};

TEST_F(ProgramTest, AProgramDoesNotLinkOpenImageIO) {
    const Ran ran = run("ldd " SAVE_IMAGE);
    EXPECT_EQ(ran.code, 0) << ran.output;
    EXPECT_EQ(ran.output.find("OpenImageIO"), std::string::npos) << ran.output;
}

TEST_F(ProgramTest, AMissingModuleIsNamedWithItsRemedy) {
    const Ran ran = run("env -u WRINKLE_MODULE_PATH " + stray_program("a.exr"));
    EXPECT_EQ(ran.code, 3);
    EXPECT_NE(ran.output.find("the image module is missing; looked for " + folder.string() +
                              "/lib/wrinkle/wrinkle_image_oiio.so"),
              std::string::npos)
        << ran.output;
    EXPECT_NE(ran.output.find("WRINKLE_MODULE_PATH"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "a.exr"));
}

TEST_F(ProgramTest, AForeignModuleIsAnErrorNotACrash) {
    const std::string command = stray_program("a.exr");
    fs::create_directories(folder / "lib/wrinkle");
    put("lib/wrinkle/wrinkle_image_oiio.so", "not a shared object");
    const Ran ran = run(command);
    EXPECT_EQ(ran.code, 3);
    EXPECT_NE(ran.output.find("the image module cannot be loaded"), std::string::npos);
}

TEST_F(ProgramTest, TheModuleIsFoundThroughTheEnvironment) {
    const Ran ran =
        run("WRINKLE_MODULE_PATH=/nowhere::" IMAGE_MODULE_FOLDER " " + stray_program("a.exr"));
    EXPECT_EQ(ran.code, 0) << ran.output;
    EXPECT_TRUE(fs::exists(folder / "a.exr"));
}

TEST_F(ProgramTest, PngNeedsNoModule) {
    const Ran ran = run("env -u WRINKLE_MODULE_PATH " + stray_program("a.png"));
    EXPECT_EQ(ran.code, 0) << ran.output;
    EXPECT_TRUE(fs::exists(folder / "a.png"));
}

TEST_F(ProgramTest, RemadeTexturesAreTheCommittedOnes) {
    const Ran ran = run(MAKE_TEXTURES " " + folder.string());
    ASSERT_EQ(ran.code, 0) << ran.output;
    EXPECT_EQ(ran.output, "");
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const Image made = loaded(entry.path());
        const Image kept = loaded(committed / entry.path().filename());
        EXPECT_EQ(made.source, PixelType::u16);
        EXPECT_EQ(made.width, kept.width) << entry.path();
        EXPECT_TRUE(made.data == kept.data) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 6u);
}

// A graph reads only files below its own folder, so graphs/compare has copies of the textures.
TEST(Textures, OfTheComparisonsAreThoseOfTheSamples) {
    size_t count = 0;
    for (const auto& entry : fs::directory_iterator(committed / "../compare/textures")) {
        const Image copy = loaded(entry.path());
        EXPECT_TRUE(copy.data == loaded(committed / entry.path().filename()).data) << entry.path();
        ++count;
    }
    EXPECT_EQ(count, 3u);
}

TEST(Textures, TheWovenNormalsAreThoseOfTheWovenHeights) {
    const Image height = loaded(committed / "weave_height.png");
    const Image normal = loaded(committed / "weave_normal.png");
    const uint32_t size = height.width;
    size_t near = 0;
    for (uint32_t y = 0; y < size; ++y)
        for (uint32_t x = 0; x < size; ++x) {
            const auto at = [&](uint32_t i, uint32_t j) {
                return double(*height.texel(i % size, j % size));
            };
            const double du = (at(x + 1, y) - at(x + size - 1, y)) * size / 2 * 0.04;
            const double dv = (at(x, y + 1) - at(x, y + size - 1)) * size / 2 * 0.04;
            const float* texel = normal.texel(x, y);
            const double nx = 2 * texel[0] - 1, ny = 2 * texel[1] - 1, nz = 2 * texel[2] - 1;
            near += std::abs(-nx / nz - du) < 0.08 && std::abs(-ny / nz - dv) < 0.08;
        }
    EXPECT_GT(near, size_t{size} * size * 8 / 10);  // the other texels are on creases
}

TEST(Textures, HeightsTile) {
    for (const char* name : {"bricks_height.png", "pebbles_height.png", "patches_mask.png"}) {
        const Image image = loaded(committed / name);
        double seam = 0, inside = 0;
        for (uint32_t i = 0; i < image.width; ++i) {
            seam += std::abs(*image.texel(i, 0) - *image.texel(i, image.height - 1)) +
                    std::abs(*image.texel(0, i) - *image.texel(image.width - 1, i));
            for (uint32_t j = 1; j < image.height; ++j)
                inside += (std::abs(*image.texel(i, j) - *image.texel(i, j - 1)) +
                           std::abs(*image.texel(j, i) - *image.texel(j - 1, i))) /
                          (image.height - 1);
        }
        EXPECT_LT(seam, 3 * inside) << name;
    }
}

TEST(Textures, TheBallFacesOutward) {
    const Image ball = loaded(committed / "ball_object.png");
    const double pi = std::acos(-1);
    for (uint32_t y = 0; y < ball.height; y += 5)
        for (uint32_t x = 0; x < ball.width; x += 5) {
            const double longitude = 2 * pi * ((x + 0.5) / ball.width - 0.5);
            const double latitude = pi * ((y + 0.5) / ball.height - 0.5);
            const double point[] = {std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                                    std::cos(latitude) * std::cos(longitude)};
            double along = 0, square = 0;
            for (uint32_t i = 0; i < 3; ++i) {
                const double n = 2 * ball.texel(x, y)[i] - 1;
                along += n * point[i];
                square += n * n;
            }
            EXPECT_NEAR(square, 1, 2e-4);
            EXPECT_GT(along, 0.5);  // within 60 degrees of the sphere's normal
        }
}

}  // namespace
}  // namespace wrinkle::test
