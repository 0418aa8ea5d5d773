// Tests of textures against a slow reference without shortcuts: the weight of a texel is the
// overlap of its tent filter, centred on it and one texel wide to either side, with the sampled
// position.
#include "cpu/texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "cpu/support.h"

namespace wrinkle::test {
namespace {

Image random_image(uint32_t width, uint32_t height, uint32_t channels) {
    std::mt19937 random(width * 31 + height * 7 + channels);
    Image image = make_image(width, height, channels);
    for (float& value : image.data)
        value = static_cast<float>(random() % 1000) / 1000.0F;
    return image;
}

int reference_texel(int i, int n, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::min(std::max(i, 0), n - 1);
    const int period = wrap == Wrap::mirror ? 2 * n : n;
    const int folded = ((i % period) + period) % period;
    return folded < n ? folded : 2 * n - 1 - folded;
}

// Weight of texel i of n at u; i may be outside of 0..n-1.
double weight(double u, int i, int n, Filter filter) {
    const double place = u * n;
    if (filter == Filter::nearest) return place >= i && place < i + 1;
    return std::max(0.0, 1 - std::fabs(place - (i + 0.5)));
}

std::array<double, 4> reference_level(const Image& image, double u, double v,
                                      const TextureOptions& options) {
    const int w = static_cast<int>(image.width), h = static_cast<int>(image.height);
    std::array<double, 4> sum{};
    for (int y = -3 * h; y < 4 * h; ++y) {
        const double wy = weight(v, y, h, options.filter);
        for (int x = -3 * w; wy > 0 && x < 4 * w; ++x) {
            const double wx = weight(u, x, w, options.filter);
            if (wx <= 0) continue;
            const auto column = static_cast<uint32_t>(reference_texel(x, w, options.wrap));
            const auto row = static_cast<uint32_t>(reference_texel(y, h, options.wrap));
            const auto texel =
                expand_texel(image.texel(column, row), image.channels, image.has_alpha);
            for (size_t k = 0; k < 4; ++k)
                sum[k] += wx * wy * static_cast<double>(texel[k]);
        }
    }
    return sum;
}

std::array<double, 4> reference(const MipChain& chain, double u, double v, double lod,
                                const TextureOptions& options) {
    const double last = chain.count() - 1.0, inside = std::min(std::max(lod, 0.0), last);
    if (options.filter == Filter::nearest) {
        const auto level = static_cast<size_t>(std::floor(inside + 0.5));
        return reference_level(chain.levels[level], u, v, options);
    }
    std::array<double, 4> sum{};
    for (size_t level = 0; level < chain.count(); ++level) {
        const double share = std::max(0.0, 1 - std::fabs(inside - static_cast<double>(level)));
        if (share <= 0) continue;
        const auto texel = reference_level(chain.levels[level], u, v, options);
        for (size_t k = 0; k < 4; ++k)
            sum[k] += share * texel[k];
    }
    return sum;
}

struct Size {
    uint32_t width, height, channels;
};

void expect_as_reference(const Size& size, const TextureOptions& options) {
    const MipChain chain = build_mips(random_image(size.width, size.height, size.channels));
    const Texture texture(chain, options);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uv(-2, 3), lods(-1, 6);
    for (int i = 0; i < 60; ++i) {
        const auto u = static_cast<float>(uv(random)), v = static_cast<float>(uv(random));
        const auto lod = static_cast<float>(i % 3 == 0 ? std::floor(lods(random)) : lods(random));
        const auto wanted = reference(chain, u, v, lod, options);
        const auto full = texture.sample_lod<double>(u, v, lod);
        const auto single = texture.sample_lod<float>(u, v, lod);
        for (size_t k = 0; k < 4; ++k) {
            EXPECT_NEAR(full[k], wanted[k], 1e-12) << u << " " << v << " lod " << lod;
            if (options.filter == Filter::linear) {
                EXPECT_NEAR(single[k], wanted[k], 2e-5) << u << " " << v << " lod " << lod;
            }
        }
    }
}

TEST(Textures, AgreeWithTheReference) {
    for (const Size& size : {Size{1, 1, 1}, {2, 2, 3}, {5, 3, 4}, {8, 8, 2}, {7, 16, 1}, {1, 9, 4}})
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
            for (const Filter filter : {Filter::linear, Filter::nearest}) {
                SCOPED_TRACE(std::to_string(size.width) + "x" + std::to_string(size.height) + " " +
                             std::string(name_of(wrap)) + " " + std::string(name_of(filter)));
                expect_as_reference(size, {Encoding::linear, wrap, filter});
            }
}

TEST(Textures, TexelCentresGiveTexels) {
    const Image image = random_image(6, 5, 4);
    const Texture texture(build_mips(image), {});
    for (uint32_t y = 0; y < 5; ++y)
        for (uint32_t x = 0; x < 6; ++x) {
            const auto got = texture.sample_lod<double>((x + 0.5) / 6, (y + 0.5) / 5, 0);
            for (size_t k = 0; k < 4; ++k)
                EXPECT_NEAR(got[k], static_cast<double>(image.texel(x, y)[k]), 1e-14);
        }
}

TEST(Textures, AConstantStaysToTheBit) {
    Image image = make_image(5, 7, 3);
    for (size_t i = 0; i < image.data.size(); ++i)
        image.data[i] = i % 3 == 0 ? 0.1F : i % 3 == 1 ? 0.7F : 1e-20F;
    const Texture texture(build_mips(image), {});
    for (int i = 0; i < 200; ++i) {
        const auto got = texture.sample_lod<float>(0.0137F * i, 0.0271F * i, 0.02F * i);
        EXPECT_EQ(got, (std::array<float, 4>{0.1F, 0.7F, 1e-20F, 1}));
    }
}

template <class T>
void expect_safe_anywhere() {
    for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
        for (const Filter filter : {Filter::linear, Filter::nearest}) {
            const Texture texture(build_mips(random_image(5, 4, 3)),
                                  {Encoding::linear, wrap, filter});
            const double bad[] = {std::nan(""), infinity,     -infinity, 1e30,   -1e30,
                                  3e9,          -3e9,         1e-30,     -1e-30, 1,
                                  -1,           4294967296.5, 1e308,     -0.0,   1.999999999999};
            for (const double u : bad)
                for (const double lod : bad) {
                    const auto texel = texture.sample_lod<T>(static_cast<T>(u), static_cast<T>(lod),
                                                             static_cast<T>(lod));
                    for (const T value : texel)
                        EXPECT_TRUE(value >= 0 && value <= 1) << u << " lod " << lod;
                }
        }
}

TEST(Textures, NoCoordinateReadsOutsideInFloat) {
    expect_safe_anywhere<float>();
}
TEST(Textures, NoCoordinateReadsOutsideInDouble) {
    expect_safe_anywhere<double>();
}

TEST(Textures, NanAndInfinityReadAsZero) {
    const Texture texture(build_mips(random_image(4, 4, 4)), {});
    const auto zero = texture.sample_lod<float>(0, 0, 0);
    const auto inf = std::numeric_limits<float>::infinity();
    EXPECT_EQ(texture.sample_lod<float>(inf, -inf, 0), zero);
    EXPECT_EQ(texture.sample_lod<float>(std::nanf(""), 0, std::nanf("")), zero);
}

TEST(Textures, AnEmptyOneIsOneBlackTexel) {
    const Texture texture;
    EXPECT_EQ(texture.width(), 1u);
    EXPECT_EQ(texture.sample_lod<float>(0.3F, 9, 2), (std::array<float, 4>{0, 0, 0, 1}));
    EXPECT_EQ(Texture(MipChain{}, {}).sample_lod<double>(0, 0, 0),
              (std::array<double, 4>{0, 0, 0, 1}));
}

// The ops in a program: two textures, a different lod at each point, and explicit gradients.
TEST(TextureOps, ReadTheirOwnResource) {
    constexpr size_t points = 50;
    Scene s(points);
    Module& m = s.m;
    std::vector<MipChain> chains = {build_mips(random_image(8, 4, 3)),
                                    build_mips(random_image(16, 16, 1))};
    std::vector<Texture> textures;
    for (uint32_t i = 0; i < 2; ++i) {
        Resource resource;
        resource.file = "image" + std::to_string(i);
        m.add_resource(resource);
        textures.emplace_back(chains[i], TextureOptions{});
    }
    const Id uv = m.construct(Type::vec2_, {s.numbers([](size_t k) { return 0.03 * k; }),
                                            s.numbers([](size_t k) { return 1 - 0.05 * k; })});
    const Id lod = s.numbers([](size_t k) { return 0.1 * k - 0.5; });
    const Id dx =
        m.construct(Type::vec2_, {s.numbers([](size_t k) { return 0.01 * k; }), m.number(0.002)});
    const Id dy = m.construct(Type::vec2_, {m.number(0.03), m.number(-0.04)});
    s.output(m.add(Op::sample_lod_, {uv, lod}, 1));
    s.output(m.add(Op::sample_grad_, {uv, dx, dy}, 0));
    s.output(m.add(Op::image_size_, {}, 0));
    const Results results = evaluate_all<double>(s, textures);
    for (size_t k = 0; k < points; ++k) {
        const double u = 0.03 * k, v = 1 - 0.05 * k;
        const double along =
            std::max(std::hypot(8 * 0.01 * k, 4 * 0.002), std::hypot(8 * 0.03, 4 * 0.04));
        const auto by_lod = reference(chains[1], u, v, 0.1 * k - 0.5, {});
        const auto by_gradient = reference(chains[0], u, v, std::log2(along), {});
        for (size_t i = 0; i < 4; ++i) {
            EXPECT_NEAR(results.values[0][k * 4 + i], by_lod[i], 1e-12);
            EXPECT_NEAR(results.values[1][k * 4 + i], by_gradient[i], 1e-11);
        }
        EXPECT_EQ(results.values[2][k * 2], 8);
        EXPECT_EQ(results.values[2][k * 2 + 1], 4);
    }
}

}  // namespace
}  // namespace wrinkle::test
