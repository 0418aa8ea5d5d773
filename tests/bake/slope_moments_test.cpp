// Tests of the second moments of baked slopes if a texel of the map covers many of the texture:
// against slopes known at every texel of the texture, and against a bake at its resolution.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "bake/support.h"
#include "mesh/shapes.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

constexpr uint32_t fine = 1024, coarse = 256, block = fine / coarse;
constexpr double plane_side = 2;  // in units of length, for uv from 0 to 1

using Slope = std::array<double, 2>;
using Moments = std::array<double, 3>;  // ss, tt, st with t downwards

// Anisotropic waves with a period of a few texels, plus long waves.
Slope slope_at(double u, double v) {
    const auto wave = [&](int across, int up, double phase) {
        return std::cos(2 * std::numbers::pi * (across * u + up * v) + phase);
    };
    return {0.25 * wave(170, 60, 0) + 0.12 * wave(-90, 210, 1) + 0.2 * wave(1, 0, 2),
            0.09 * wave(170, 60, 0) - 0.28 * wave(-90, 210, 1) + 0.1 * wave(0, 1, 0)};
}

using Picture = std::shared_ptr<const PackedMipChain>;

Picture picture_of(std::array<double, 3> (*color)(Slope)) {
    Image image = make_image(fine, fine, 3);
    for (uint32_t y = 0; y < fine; ++y)
        for (uint32_t x = 0; x < fine; ++x) {
            const auto lanes = color(slope_at((x + 0.5) / fine, (y + 0.5) / fine));
            for (size_t c = 0; c < 3; ++c)
                image.texel(x, y)[c] = static_cast<float>(lanes[c]);
        }
    return std::make_shared<const PackedMipChain>(
        std::make_shared<const MipChain>(build_mips(std::move(image))));
}

// Returns the texture for a file name of a graph.
const Picture& picture_named(const std::string& name) {
    static const Picture normals = picture_of([](Slope s) {
        const double k = 0.5 / std::hypot(s[0], s[1], 1);
        return std::array{0.5 - s[0] * k, 0.5 - s[1] * k, 0.5 + k};
    });
    static const Picture slopes = picture_of([](Slope s) { return std::array{s[0], s[1], 0.0}; });
    static const Picture moments = picture_of([](Slope s) {
        return std::array{s[0] * s[0], s[1] * s[1], s[0] * s[1]};
    });
    if (name.ends_with("_normal.png")) return normals;
    return name.ends_with("_slopes.png") ? slopes : moments;
}

// Bakes a program on a shape. A bake at the resolution of the textures reads them with the nearest
// texel, as interpolation would lose waves this short.
LanePicture baked(const char* shape, const BakePlan& plan, uint32_t size) {
    std::vector<Texture> textures;
    for (const Resource& resource : plan.resources) {
        TextureOptions options = resource.options;
        if (size == fine) options.filter = Filter::nearest;
        textures.emplace_back(picture_named(resource.name), options);
    }
    BakeHow how = {.width = size, .height = size};
    how.textures = textures;
    return bake_lanes(*make_shape(shape), plan.program, how, plan.unit);
}

constexpr const char* normal_map =
    R"({"type": "tangent_normal_map", "in": {"image": "textures/weave_normal.png")";
constexpr const char* moments_map =
    R"({"type": "slope_moments_map", "in": {"slopes": "textures/pebbles_slopes.png",
        "moments": "textures/pebbles_moments.png", "scale": "unit")";

// Bakes the slopes of the node "bump": channels b0 to b5 per texel.
LanePicture baked_slopes(const std::string& nodes, uint32_t size) {
    const Module module = bake_module(
        nodes + R"(, "end": {"type": "resolve", "in": {"gradient": {"from": "bump.gradient"}}})",
        R"("normal": {"from": "end.normal"})");
    MapOptions options;
    options.width = options.height = size;
    const BakePlan plan = plan_of(module, {"slopes"}, options, false);
    const LanePicture lanes = baked("plane", plan, size);
    LanePicture stored = lanes;
    stored.lanes = plan.maps[0].channels.size();
    stored.values.clear();
    for (size_t texel = 0; texel < lanes.covered.size(); ++texel)
        for (const MapChannel& channel : plan.maps[0].channels)
            stored.values.push_back(lanes.values[texel * lanes.lanes + channel.lane]);
    return stored;
}

Moments second_moments(const float* texel) {
    return {texel[3], texel[4], texel[5]};
}

Moments products(const float* texel) {
    return {double(texel[1]) * texel[1], double(texel[2]) * texel[2], double(texel[1]) * texel[2]};
}

// Mean products of the slopes over the texels of the texture that a baked texel covers.
Moments known_moments(uint32_t x, uint32_t y) {
    constexpr double texel = plane_side / coarse;
    Moments sum{};
    for (uint32_t j = 0; j < block; ++j)
        for (uint32_t i = 0; i < block; ++i) {
            const Slope s = slope_at((x * block + i + 0.5) / fine, (y * block + j + 0.5) / fine);
            const Moments here{s[0] * s[0], s[1] * s[1], -s[0] * s[1]};
            for (size_t k = 0; k < 3; ++k)
                sum[k] += here[k] * texel * texel / (block * block);
        }
    return sum;
}

struct Errors {
    double with = 0, without = 0;  // mean error, relative to the mean trace
};

Errors errors_of(const std::string& bump) {
    const LanePicture map = baked_slopes(R"("bump": )" + bump, coarse);
    Errors errors;
    double trace = 0;
    for (uint32_t y = 0; y < coarse; y += 3)
        for (uint32_t x = 0; x < coarse; ++x) {
            const Moments known = known_moments(x, y), baked = second_moments(map.at(x, y)),
                          alone = products(map.at(x, y));
            trace += known[0] + known[1];
            for (size_t k = 0; k < 3; ++k) {
                errors.with += std::fabs(baked[k] - known[k]);
                errors.without += std::fabs(alone[k] - known[k]);
            }
        }
    return {errors.with / trace, errors.without / trace};
}

TEST(BakedMoments, AreThoseOfTheSlopesWithinATexel) {
    const Errors errors = errors_of(std::string(moments_map) + "}}");
    EXPECT_LT(errors.with, 1e-4);
    EXPECT_GT(errors.without, 0.5);
}

// The moments come from the length of the mean normal: isotropic, so only approximate.
TEST(BakedMoments, OfANormalMapAreNearlyThose) {
    const Errors errors = errors_of(std::string(normal_map) + "}}");
    EXPECT_LT(errors.with, 0.3);
    EXPECT_GT(errors.without, 0.5);
}

// Compares the moments over the map with those of the fine bake, in units of the coarse texel.
void expect_means_of_the_fine_bake(const std::string& nodes, double tolerance) {
    Moments small{}, large{}, alone{};
    const LanePicture map = baked_slopes(nodes, coarse), truth = baked_slopes(nodes, fine);
    const auto add = [](Moments& sum, const Moments& more, double factor) {
        for (size_t k = 0; k < 3; ++k)
            sum[k] += more[k] * factor;
    };
    for (uint32_t y = 0; y < fine; ++y)
        for (uint32_t x = 0; x < fine; ++x)
            add(large, products(truth.at(x, y)), 1);
    for (uint32_t y = 0; y < coarse; ++y)
        for (uint32_t x = 0; x < coarse; ++x) {
            add(small, second_moments(map.at(x, y)), 1);
            add(alone, products(map.at(x, y)), 1);
        }
    const double trace = large[0] + large[1];
    for (size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(small[k], large[k], tolerance * trace) << k;
    EXPECT_GT(std::fabs(large[2]), 4 * tolerance * trace);  // or rotated frames would not show
    EXPECT_LT(alone[0] + alone[1], 0.6 * trace);
}

TEST(BakedMoments, OfLayersAreThoseOfTheirSum) {
    const std::string tile = R"("tile": {"type": "uv_transform", "in": {"rotation": 30}}, )";
    const std::string turned = std::string(moments_map) + R"(, "uv": {"from": "tile.uv"}}})";
    expect_means_of_the_fine_bake(tile + R"("bump": )" + turned, 0.01);
    expect_means_of_the_fine_bake(tile + R"("a": )" + moments_map +
                                      R"(, "strength": 0.6}}, "b": )" + turned +
                                      R"(, "bump": {"type": "gradient_mix", "in":
        {"a": {"from": "a.gradient"}, "b": {"from": "b.gradient"}, "mask": 0.7}})",
                                  0.01);
}

// The moments change no bit of other maps baked in the same run, nor of a map baked separately.
TEST(BakedMoments, LeaveOtherMapsAsTheyAre) {
    for (const char* name : {"base_and_detail.json", "woven_strap.json", "far_away.json"}) {
        const std::string text = bytes_of(std::string(WRINKLE_SOURCE_DIR "/graphs/") + name);
        const Module plain = bake_module_of(text, true, Covariances::dropped);
        ASSERT_FALSE(plain.outputs.empty());
        const BakePlan alone = plan_of(plain, {"normal"}),
                       beside = plan_of(bake_module_of(text), {"normal", "slopes"}, {}, false);
        EXPECT_EQ(alone.resources.size(),
                  plan_of(bake_module_of(text), {"normal"}).resources.size());
        const auto normals = [](const BakePlan& plan) {
            const LanePicture map = baked("torus", plan, 64);
            std::vector<float> result;
            for (size_t texel = 0; texel < map.covered.size(); ++texel)
                for (size_t c = 0; c < 3; ++c)
                    result.push_back(map.values[texel * map.lanes + plan.maps[0].channels[c].lane]);
            return result;
        };
        EXPECT_EQ(normals(alone), normals(beside)) << name;
    }
}

}  // namespace
}  // namespace wrinkle::test
