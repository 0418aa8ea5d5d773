// Tests of small renderings against large ones that are downsampled: bumped metal balls under a
// directional light, where the bump is finer than a pixel, and filtered patterns.
#include <cmath>

#include "cli/support.h"
#include "image/load.h"

namespace wrinkle::test {
namespace {

// The metal is dark enough that its highlights are not clipped.
std::string dark_metal(const std::string& bump, const std::string& normal) {
    return R"({"wrinkle": 1, "nodes": {)" + bump + R"(,
    "rough": {"type": "bump_roughness", "in": {"gradient": {"from": ")" +
           normal + R"("},
              "roughness": 0.3}},
    "metal": {"type": "add", "in": {"a": 0.5, "b": 0.5}},
    "dark": {"type": "combine_vec3", "in": {"x": 0.03, "y": 0.03, "z": 0.03}}},
  "outputs": {"normal": {"from": ")" +
           normal + R"("}, "roughness": {"from": "rough.roughness"},
              "metalness": {"from": "metal.result"}, "color": {"from": "dark.vector"}}})";
}

double linear(float shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

// The linear red values of a square image.
std::vector<double> light_of(const fs::path& picture) {
    Diagnostics diagnostics;
    const auto image = load_image(picture, diagnostics);
    EXPECT_TRUE(image) << to_text(diagnostics);
    std::vector<double> light;
    for (uint32_t y = 0; image && y < image->height; ++y)
        for (uint32_t x = 0; x < image->width; ++x)
            light.push_back(linear(image->texel(x, y)[0]));
    return light;
}

// An image of `side` pixels: means of blocks of a larger one.
std::vector<double> reduced(const std::vector<double>& light, uint32_t side) {
    const auto size = static_cast<uint32_t>(std::lround(std::sqrt(light.size())));
    const uint32_t block = size / side;
    std::vector<double> means(size_t{side} * side, 0);
    for (size_t i = 0; i < light.size(); ++i)
        means[i / size / block * side + i % size / block] += light[i] / (block * block);
    return means;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

class FarHighlight : public CliTest {
protected:
    // The ball of g.json, with bump_roughness times `amount`.
    std::vector<double> light(uint32_t side, const std::string& amount) {
        const std::string size = std::to_string(side);
        const Ran ran = run({"render", "g.json", "-o", "g.png", "--size", size + "x" + size,
                             "--set", "rough.amount=" + amount, "--light", "sun", "--tone",
                             "linear", "--background", "plain"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        return light_of(folder / "g.png");
    }
};

TEST_F(FarHighlight, IsThatOfTheBumpSeenInFull) {
    put("g.json", dark_metal(R"("tile": {"type": "uv_transform", "in": {"scale": [24, 24]}},
        "weave": {"type": "tangent_normal_map", "in": {"image": "weave_normal.png",
                  "uv": {"from": "tile.uv"}}})",
                             "weave.gradient"));
    fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/textures/weave_normal.png",
                  folder / "weave_normal.png");
    const auto right = reduced(light(768, "0"), 48);
    const double with = distance(light(48, "1"), right);
    const double without = distance(light(48, "0"), right);
    EXPECT_LT(with * 3, without) << with << " " << without;
}

// Four distances: a pixel of the smallest image has many cells, of the largest less than one. There
// the bump itself is visible, and its roughness must not add an error.
TEST_F(FarHighlight, OfProceduralBumpsAtFourDistances) {
    const struct {
        const char *type, *in;
        double closer[4];  // how many times closer to the truth than without bump_roughness
    } bumps[] = {
        {"fbm", R"("scale": 20, "amplitude": 0.03)", {4, 2, 2, 1.4}},
        {"weave", R"("scale": 120, "amplitude": 0.003)", {2.5, 2.5, 0.9, 0.85}},
        {"hexagons", R"("scale": 60, "amplitude": 0.002)", {2, 1.3, 0.9, 0.9}},
    };
    for (const auto& bump : bumps) {
        const std::string node =
            R"("n": {"type": ")" + std::string(bump.type) + R"(", "in": {)" + bump.in + "}}";
        put("g.json", dark_metal(node + R"(, "g": {"type": "gradient_from_height",
                                           "in": {"height": {"from": "n.height"}}})",
                                 "g.gradient"));
        const auto large = light(768, "0");
        for (size_t i = 0; i < 4; ++i) {
            const uint32_t side = 24U << i;
            const auto right = reduced(large, side);
            const double with = distance(light(side, "1"), right);
            const double without = distance(light(side, "0"), right);
            EXPECT_LT(with * bump.closer[i], without) << bump.type << " at " << side;
        }
    }
}

double display(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}

using ReducedPictures = CliTest;

// The mean over the pixels in display values: patterns are filtered, as pixels of the large image
// are averaged.
TEST_F(ReducedPictures, OfAQuarterOfTheSizeAreTheLargeOnesReduced) {
    for (const char* graph : {"nodes/checker.json", "nodes/wave.json", "nodes/bricks.json",
                              "materials/terrazzo.json"}) {
        const auto light = [&](const std::string& size) {
            const Ran ran =
                run({"render", WRINKLE_SOURCE_DIR "/graphs/" + std::string(graph), "-o", "p.png",
                     "--size", size + "x" + size, "--tone", "linear", "--background", "plain"});
            EXPECT_EQ(ran.code, 0) << ran.err;
            return light_of(folder / "p.png");
        };
        const auto large = reduced(light("256"), 64), small = light("64");
        double sum = 0;
        for (size_t i = 0; i < small.size(); ++i)
            sum += std::fabs(display(large[i]) - display(small[i]));
        EXPECT_LT(sum / static_cast<double>(small.size()), 3.0 / 255) << graph;
    }
}

}  // namespace
}  // namespace wrinkle::test
