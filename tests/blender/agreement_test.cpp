// Tangent-space normals beside Blender's bake operator, texel by texel: one mesh, the same images.
//
// Left out are texels less than two from the border of an island, and those where one of the
// normals leans more than 40 degrees: Blender bends normals that mirror the view, here straight
// from above, into the surface, which begins at 45 degrees from the flat triangle.
//
// Blender's bump is a forward difference of the height over about a texel of the map, in directions
// that do not follow the uvs; ours is the slope at the texel's centre. So theirs is off by half its
// step times the curvature of the height, and comes nearer to ours as texels become smaller.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/support.h"
#include "image/load.h"
#include "mesh/load.h"
#include "mesh/uv_raster.h"
#include "support/angle.h"

namespace wrinkle::test {
namespace {

constexpr uint32_t margin = 2;
constexpr double most_tilt = 40, pi = 3.14159265358979323846;

// Degrees between two maps.
struct Apart {
    std::vector<double> sorted;
    size_t covered = 0, left_out = 0;  // left_out: covered, but too tilted

    double at(double part) const {
        return sorted.empty() ? 180 : sorted[static_cast<size_t>(part * double(sorted.size() - 1))];
    }
};

// A height without creases, two waves each way.
void save_waves(const fs::path& path) {
    Image image = make_image(256, 256, 1);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            *image.texel(x, y) = static_cast<float>(0.5 + 0.25 * std::sin((x + 0.5) * pi / 64) +
                                                    0.25 * std::sin((y + 0.5) * pi / 64));
    WriterOptions options;
    options.type = PixelType::u16;
    Diagnostics diagnostics;
    EXPECT_TRUE(save_image(image, path, options, diagnostics)) << to_text(diagnostics);
}

class BlenderTest : public CliTest {
protected:
    void SetUp() override {
        CliTest::SetUp();
        const fs::path from = WRINKLE_SOURCE_DIR;
        fs::create_directories(folder / "tests/blender");
        fs::create_directories(folder / "graphs/textures");
        fs::copy(from / "tests/blender/graph.json", folder / "tests/blender");
        fs::copy(from / "graphs/textures/rivets_normal.png", folder / "graphs/textures");
        save_waves(folder / "graphs/textures/weave_height.png");
    }

    // Bakes one case in Blender.
    void in_blender(const std::string& name, uint32_t size) {
        side = size;
        program = BLENDER;
        const Ran ran =
            run({"--background", "--factory-startup", "--python-exit-code", "1", "--python",
                 WRINKLE_SOURCE_DIR "/tests/blender/bake.py", "--", folder.string(),
                 folder / "graphs/textures/rivets_normal.png",
                 folder / "graphs/textures/weave_height.png", std::to_string(side), "1", name});
        program = WRINKLE_BINARY_DIR "/bin/wrinkle";
        ASSERT_EQ(ran.code, 0) << ran.out << ran.err;
        blender_ = picture(name + ".pfm");
        Diagnostics diagnostics;
        auto mesh = load_mesh(folder / "mesh.obj", {}, diagnostics);
        ASSERT_TRUE(mesh) << to_text(diagnostics);
        const UvRaster raster(*mesh, {side, side});
        raster.cover({0, 0, side, side}, raster.in_rows(0, side), coverage_);
    }

    // Bakes an output of the graph and compares.
    Apart apart(const std::string& output, std::vector<std::string> more = {}) {
        more.insert(more.begin(),
                    {"bake", "tests/blender/graph.json", "--root", ".", "--mesh", "mesh.obj", "-o",
                     "ours.exr", "--map", output, "--size", std::to_string(side), "--type", "float",
                     "--samples", "1", "--dilate", "0"});
        const Ran ran = run(more);
        EXPECT_EQ(ran.code, 0) << ran.err;
        const Image ours = picture("ours.exr");
        Apart result;
        for (uint32_t y = margin; y < side - margin; ++y)
            for (uint32_t x = margin; x < side - margin; ++x)
                if (is_inside(x, y)) compare(ours.texel(x, y), blender_.texel(x, y), result);
        std::sort(result.sorted.begin(), result.sorted.end());
        std::printf(
            "%-10s median %.4f, 99 %% %.4f, 99.9 %% %.4f, greatest %.4f degrees; %zu of "
            "%zu texels, %zu too steep\n",
            output.c_str(), result.at(0.5), result.at(0.99), result.at(0.999), result.at(1),
            result.sorted.size(), result.covered, result.left_out);
        return result;
    }

private:
    Image picture(const std::string& name) const {
        Diagnostics diagnostics;
        auto image = load_image(folder / name, diagnostics);
        EXPECT_TRUE(image) << to_text(diagnostics);
        return image ? std::move(*image) : make_image(side, side, 3);
    }
    bool is_inside(uint32_t x, uint32_t y) const {
        for (uint32_t v = y - margin; v <= y + margin; ++v)
            for (uint32_t u = x - margin; u <= x + margin; ++u)
                if (coverage_.owners[v * side + u] == Coverage::none) return false;
        return true;
    }
    static void compare(const float* ours, const float* theirs, Apart& result) {
        double a[3], b[3];
        for (int i = 0; i < 3; ++i) {
            a[i] = 2 * double(ours[i]) - 1;
            b[i] = 2 * double(theirs[i]) - 1;
        }
        ++result.covered;
        const double up[3] = {0, 0, 1};
        if (std::max(angle_deg(a, up), angle_deg(b, up)) > most_tilt)
            ++result.left_out;
        else
            result.sorted.push_back(angle_deg(a, b));
    }

    uint32_t side = 0;
    Image blender_;
    Coverage coverage_;
};

TEST_F(BlenderTest, ANormalMapIsTheSame) {
    in_blender("normal_map", 1024);
    const Apart there = apart("normal_map");
    EXPECT_GT(there.sorted.size(), 850'000U);
    EXPECT_LT(there.at(0.5), 0.005);
    EXPECT_LT(there.at(1), 0.1);
    EXPECT_GT(apart("normal_map", {"--dx"}).at(0.9), 5) << "green is up";
}

TEST_F(BlenderTest, ABumpIsTheSameButForTheStepOfADifference) {
    in_blender("bump", 512);
    const Apart coarse = apart("bump");
    in_blender("bump", 1024);
    const Apart fine = apart("bump");
    EXPECT_GT(fine.sorted.size(), 900'000U);
    EXPECT_LT(fine.at(0.5), 0.4);
    EXPECT_LT(fine.at(0.99), 2.6);
    EXPECT_LT(fine.at(1), 5);
    EXPECT_GT(coarse.at(0.5) / fine.at(0.5), 1.5) << "both come to one slope";
    EXPECT_GT(coarse.at(0.99) / fine.at(0.99), 1.5);
}

// A bump on the normal of a map is a chain there, compare_bump_over_normal here. The sum of both is
// another normal, which is what that node is about.
TEST_F(BlenderTest, ABumpOnANormalMapIsTheNodeThatSaysSo) {
    in_blender("both", 1024);
    const Apart chain = apart("both"), sum = apart("normal");
    EXPECT_GT(chain.sorted.size(), 800'000U);
    EXPECT_LT(chain.at(0.5), 0.4);
    EXPECT_LT(chain.at(0.99), 2.7);
    EXPECT_LT(chain.at(1), 6);
    EXPECT_GT(sum.at(0.99), 2 * chain.at(0.99));
}

}  // namespace
}  // namespace wrinkle::test
