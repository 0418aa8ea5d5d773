// Test of normal variance: a bumped metal ball under a directional light, rendered so small that
// its weave is finer than a pixel, against a large rendering that is downsampled.
#include <cmath>

#include "cli/support.h"
#include "image/load.h"

namespace wrinkle::test {
namespace {

constexpr uint32_t side = 48, finer = 16;

// The metal is dark enough that its highlights are not clipped.
constexpr const char* dark_metal = R"({"wrinkle": 1, "nodes": {
    "tile": {"type": "uv_transform", "in": {"scale": [24, 24]}},
    "weave": {"type": "tangent_normal_map", "in": {"image": "weave_normal.png",
              "uv": {"from": "tile.uv"}}},
    "rough": {"type": "bump_roughness", "in": {"gradient": {"from": "weave.gradient"},
              "roughness": 0.3}},
    "metal": {"type": "add", "in": {"a": 0.5, "b": 0.5}},
    "dark": {"type": "combine_vec3", "in": {"x": 0.03, "y": 0.03, "z": 0.03}}},
  "outputs": {"normal": {"from": "weave.gradient"}, "roughness": {"from": "rough.roughness"},
              "metalness": {"from": "metal.result"}, "color": {"from": "dark.vector"}}})";

double linear(float shown) {
    return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

// Linear red values; each is the mean of block x block pixels.
std::vector<double> light_of(const fs::path& picture, uint32_t block) {
    Diagnostics diagnostics;
    const auto image = load_image(picture, diagnostics);
    EXPECT_TRUE(image && image->width == side * block) << to_text(diagnostics);
    std::vector<double> light(size_t{side} * side, 0);
    for (uint32_t y = 0; y < image->height; ++y)
        for (uint32_t x = 0; x < image->width; ++x)
            light[y / block * size_t{side} + x / block] +=
                linear(image->texel(x, y)[0]) / (block * block);
    return light;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i)
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

using FarHighlight = CliTest;

TEST_F(FarHighlight, IsThatOfTheBumpSeenInFull) {
    put("g.json", dark_metal);
    fs::copy_file(WRINKLE_SOURCE_DIR "/graphs/textures/weave_normal.png",
                  folder / "weave_normal.png");
    const auto light = [&](uint32_t block, const std::string& amount) {
        const std::string size = std::to_string(side * block);
        const Ran ran = run({"render", "g.json", "-o", "g.png", "--size", size + "x" + size,
                             "--set", "rough.amount=" + amount, "--light", "sun", "--tone",
                             "linear", "--background", "plain"});
        EXPECT_EQ(ran.code, 0) << ran.err;
        return light_of(folder / "g.png", block);
    };
    const auto right = light(finer, "0");
    const double with = distance(light(1, "1"), right), without = distance(light(1, "0"), right);
    EXPECT_LT(with * 3, without) << with << " " << without;
}

}  // namespace
}  // namespace wrinkle::test
