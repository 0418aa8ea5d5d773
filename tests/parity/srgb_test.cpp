// Tests of images of encoding srgb on CPU and GPU against an oracle in double that shares no code
// with them: the sampler decodes every texel before it builds mips and filters; with the shader as
// decoder, the filtered stored value is decoded.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "certify/points.h"
#include "cpu/texture_store.h"
#include "parity/compare.h"
#include "parity/context.h"
#include "parity/node_graph.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

constexpr size_t image_side = 16;
constexpr double top_level = 4;

using Color = std::array<double, 3>;
using Level = std::vector<Color>;  // rows of texels from the bottom

double decoded(double c) {
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}
Color decoded(Color c) {
    return {decoded(c[0]), decoded(c[1]), decoded(c[2])};
}

Color mixed(const Color& a, const Color& b, double weight) {
    Color result;
    for (size_t i = 0; i < 3; ++i)
        result[i] = a[i] * (1 - weight) + b[i] * weight;
    return result;
}

// Texels with steps of the type, many of them dark.
Level random_level(PixelType type) {
    std::mt19937 random(5);
    const double steps = type == PixelType::u8 ? 255 : 65535;
    Level level(image_side * image_side);
    for (Color& texel : level)
        for (double& value : texel)
            value = std::round(std::pow(static_cast<double>(random()) / 4294967295.0, 2) * steps) /
                    steps;
    return level;
}

std::vector<Level> with_mips(Level level) {
    std::vector<Level> levels{level};
    for (size_t n = image_side / 2; n > 0; n /= 2) {
        Level next;
        for (size_t y = 0; y < n; ++y)
            for (size_t x = 0; x < n; ++x) {
                const Color* texel = &level[2 * y * 2 * n + 2 * x];
                next.push_back(mixed(mixed(texel[0], texel[1], 0.5),
                                     mixed(texel[2 * n], texel[2 * n + 1], 0.5), 0.5));
            }
        levels.push_back(level = std::move(next));
    }
    return levels;
}

Color bilinear(const Level& level, double u, double v) {
    const auto n = static_cast<int>(std::lround(std::sqrt(level.size())));
    const double x = u * n - 0.5, y = v * n - 0.5;
    const auto texel = [&](int right, int up) {
        const auto wrapped = [&](double at, int step) {
            return static_cast<size_t>(((static_cast<int>(std::floor(at)) + step) % n + n) % n);
        };
        return level[wrapped(y, up) * static_cast<size_t>(n) + wrapped(x, right)];
    };
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    return mixed(mixed(texel(0, 0), texel(1, 0), fx), mixed(texel(0, 1), texel(1, 1), fx), fy);
}

Color sampled(const std::vector<Level>& levels, double u, double v, double lod) {
    const auto below = static_cast<size_t>(std::min(std::floor(lod), top_level - 1));
    return mixed(bilinear(levels[below], u, v), bilinear(levels[below + 1], u, v),
                 lod - static_cast<double>(below));
}

class Srgb : public WithGpu {
protected:
    // Points with uv0 differentials that span a square of 2^lod texels.
    static PointSet points(const std::vector<double>& lods) {
        PointSet set = certify::random_points(lods.size(), 3);
        for (size_t i = 0; i < lods.size(); ++i) {
            const double step = std::exp2(lods[i]) / image_side;
            const std::array<double, 2> dx{step, 0}, dy{0, step};
            std::ranges::copy(dx, &set.at(SurfaceInput::uv0_, Variant::dx)[2 * i]);
            std::ranges::copy(dy, &set.at(SurfaceInput::uv0_, Variant::dy)[2 * i]);
        }
        return set;
    }

    static void save(const Level& texels, PixelType type, const std::filesystem::path& file) {
        Image image = make_image(image_side, image_side, 3, type);
        for (size_t i = 0; i < image.data.size(); ++i)
            image.data[i] = static_cast<float>(texels[i / 3][i % 3]);
        WriterOptions options;
        options.type = type;
        Diagnostics diagnostics;
        ASSERT_TRUE(save_image(image, file, options, diagnostics)) << to_text(diagnostics);
    }

    static Module material(const std::filesystem::path& folder, SrgbDecoder decoder) {
        Diagnostics diagnostics;
        const Project project =
            load_project(read_document(R"({"wrinkle": 1, "nodes": {"i": {"type": "image",
                              "in": {"image": "i.png"}}}, "outputs": {"c": {"from": "i.color"}}})",
                                       "i.json", diagnostics),
                         folder, {}, diagnostics);
        MaterialOptions options;
        options.given_differentials = true;
        options.lower.srgb = decoder;
        Compiled compiled = compile_material(project, all_nodes(), options, diagnostics);
        EXPECT_TRUE(compiled.ok) << to_text(diagnostics);
        return std::move(compiled.module);
    }
};

double max_distance(const std::vector<double>& values, const std::vector<Color>& colors) {
    double worst = 0;
    for (size_t i = 0; i < values.size(); ++i)
        worst = std::max(worst, std::fabs(values[i] - colors[i / 3][i % 3]));
    return worst;
}

// Expected values with the texels decoded before mips and filter, and behind them.
struct Expected {
    std::vector<Color> before, behind;
};

Expected expected(const Level& texels, const PointSet& points, const std::vector<double>& lods) {
    Level linear;
    for (const Color& texel : texels)
        linear.push_back(decoded(texel));
    const auto stored_mips = with_mips(texels), linear_mips = with_mips(linear);
    Expected result;
    for (size_t i = 0; i < points.count; ++i) {
        const double* uv = &points.at(SurfaceInput::uv0_)[2 * i];
        result.before.push_back(sampled(linear_mips, uv[0], uv[1], lods[i]));
        result.behind.push_back(decoded(sampled(stored_mips, uv[0], uv[1], lods[i])));
    }
    return result;
}

void expect_values(const Module& module, const PointSet& points, const std::vector<Color>& right,
                   const std::vector<Color>& wrong) {
    TextureStore store;
    Diagnostics diagnostics;
    ASSERT_EQ(module.resources.size(), 1U);
    const auto chain = store.read(texels_of(module.resources[0]), diagnostics);
    ASSERT_TRUE(chain) << to_text(diagnostics);
    const ImageOf images = [&](const std::string&) -> const MipChain& { return *chain; };
    const std::vector<double> precise = on_cpu<double>(module, points, images)[0];
    EXPECT_LE(max_distance(precise, right), 2e-7);
    EXPECT_LE(max_distance(on_cpu<float>(module, points, images)[0], right), 3e-6);
    EXPECT_LE(max_distance(on_gpu(module, points, images)[0], right), 1e-4);
    EXPECT_GE(max_distance(precise, wrong), 0.05) << "the other order of steps";
}

TEST_F(Srgb, IsDecodedBeforeMipsAndFilterOrBehindThemByTheShader) {
    std::vector<double> lods;
    for (int i = 0; i < 40; ++i)
        for (const double lod : {0.0, 0.25, 1.0, 1.5, 2.0, 2.75, 3.5, 4.0})
            lods.push_back(lod);
    const PointSet set = points(lods);
    for (const PixelType type : {PixelType::u8, PixelType::u16}) {
        SCOPED_TRACE(name_of(type));
        const TemporaryFolder folder;
        const Level texels = random_level(type);
        save(texels, type, folder.path() / "i.png");
        const auto [before, behind] = expected(texels, set, lods);
        expect_values(material(folder.path(), SrgbDecoder::sampler), set, before, behind);
        expect_values(material(folder.path(), SrgbDecoder::shader), set, behind, before);
    }
}

}  // namespace
}  // namespace wrinkle::test
