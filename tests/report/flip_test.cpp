// FLIP against the values of NVIDIA's implementation (tests/report/flip/README.md), with the
// tolerances that its file states.
#include "report/flip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "json/parse.h"
#include "report/flip_stages.h"
#include "report/pooling.h"
#include "report/support.h"
#include "support/files.h"

namespace wrinkle::test {
namespace {

using namespace report;

struct Vector {
    json::Value expected;

    std::string name() const { return text("name"); }
    std::string text(const char* key) const { return std::string(expected.find(key).as_string()); }
    double number(const char* key) const { return expected.find(key).as_number(); }
    bool is_hdr() const { return text("mode") == "hdr"; }
    double tolerance(const char* key) const {
        return expected.find("tolerance").find(key).as_number();
    }
};

std::vector<Vector> vectors() {
    Diagnostics diagnostics;
    const auto parsed =
        json::parse(bytes_of(flip_folder + "expected.json"), "expected.json", diagnostics);
    EXPECT_FALSE(diagnostics.has_errors()) << to_text(diagnostics);
    std::vector<Vector> all;
    for (const json::Member& member : parsed.root.find("cases").children())
        all.push_back({member.value});
    EXPECT_EQ(all.size(), 21U);
    return all;
}

std::pair<uint32_t, uint32_t> position(const json::Value& at) {
    return {static_cast<uint32_t>(at.at(0).as_number()),
            static_cast<uint32_t>(at.at(1).as_number())};
}

void expect_pooled(const Vector& vector, const Image& errors) {
    constexpr double weighted = 1e-4;  // as the file states
    const json::Value flip = vector.expected.find("flip");
    const auto number = [&](const char* key) { return flip.find(key).as_number(); };
    const double pixel = vector.tolerance("pixel");
    const Pooling pooled(errors);
    EXPECT_NEAR(pooled.mean(), number("mean"), vector.tolerance("mean"));
    EXPECT_NEAR(pooled.weighted_quantile(0.5), number("weighted_median"), weighted);
    EXPECT_NEAR(pooled.weighted_quantile(0.25), number("weighted_quartile_1"), weighted);
    EXPECT_NEAR(pooled.weighted_quantile(0.75), number("weighted_quartile_3"), weighted);
    EXPECT_NEAR(pooled.min(), number("min"), pixel);
    EXPECT_NEAR(pooled.max(), number("max"), pixel);
    const auto [x, y] = position(flip.find("max_at"));
    EXPECT_NEAR(from_top(errors, x, y), number("max"), pixel);
    EXPECT_EQ(from_top(errors, pooled.max_x(), pooled.max_y()), pooled.max());
    for (const json::Member& member : flip.find("percentiles_nearest_rank").children())
        EXPECT_NEAR(pooled.percentile(std::stod(std::string(member.key))), member.value.as_number(),
                    pixel);
    for (const json::Member& member : flip.find("pixels_above").children()) {
        const float limit = std::stof(std::string(member.key));
        // Values within the tolerance of the limit may be on either side.
        const auto tolerance = static_cast<float>(pixel);
        EXPECT_LE(member.value.as_number(), pooled.count_above(limit - tolerance));
        EXPECT_GE(member.value.as_number(), pooled.count_above(limit + tolerance));
    }
    for (const json::Member& member : vector.expected.find("points").children()) {
        const auto [px, py] = position(member.value.find("at"));
        EXPECT_NEAR(from_top(errors, px, py), member.value.find("flip").as_number(), pixel)
            << px << ", " << py;
    }
}

TEST(Flip, OfDisplayedImagesIsThatOfTheOriginal) {
    for (const Vector& vector : vectors()) {
        if (vector.is_hdr()) continue;
        SCOPED_TRACE(vector.name());
        const Image errors = flip(linear_image(vector.text("reference")),
                                  linear_image(vector.text("test")), vector.number("ppd"));
        EXPECT_EQ(errors.width, vector.number("width"));
        EXPECT_EQ(errors.height, vector.number("height"));
        expect_pooled(vector, errors);
    }
}

void expect_color(const json::Value& point, const char* key, const Color& color) {
    const json::Value expected = point.find(key);
    for (size_t c = 0; c < 3; ++c) {
        const double value = expected.at(c).as_number();
        EXPECT_NEAR(color[c], value, std::max(1e-4 * std::abs(value), 1e-5)) << key << " " << c;
    }
}

Color ycxcz_at(const Image& image, uint32_t x, uint32_t y) {
    const float* texel = image.texel(x, y);
    const auto rgb = expand_texel(texel, image.channels, image.has_alpha);
    return ycxcz_from_linear({rgb[0], rgb[1], rgb[2]});
}

// The point is compared stage by stage.
void expect_stages(const json::Value& point, const std::array<Image, 2>& images,
                   const std::array<Stages, 2>& stages) {
    const auto [x, top] = position(point.find("at"));
    const uint32_t y = images[0].height - 1 - top;
    expect_color(point, "reference_ycxcz", ycxcz_at(images[0], x, y));
    expect_color(point, "test_ycxcz", ycxcz_at(images[1], x, y));
    std::array<Color, 2> lab;
    for (size_t i = 0; i < 2; ++i) {
        Color filtered;
        for (size_t c = 0; c < 3; ++c)
            filtered[c] = *stages[i].ycxcz[c].texel(x, y);
        lab[i] = lab_from_ycxcz(filtered);
    }
    expect_color(point, "reference_lab_hunt", lab[0]);
    expect_color(point, "test_lab_hunt", lab[1]);
    const double color = point.find("color_error").as_number();
    EXPECT_NEAR(color_error(lab[0], lab[1]), color, std::max(1e-4 * color, 1e-5));
    const double feature = point.find("feature_error").as_number();
    EXPECT_NEAR(feature_error(*stages[0].edge.texel(x, y) - *stages[1].edge.texel(x, y),
                              *stages[0].point.texel(x, y) - *stages[1].point.texel(x, y)),
                feature, std::max(1e-4 * feature, 1e-5));
}

TEST(Flip, EveryStageIsThatOfTheOriginal) {
    size_t compared = 0;
    for (const Vector& vector : vectors()) {
        const json::Value points = vector.expected.find("points");
        if (!points.at(0).has("color_error")) continue;
        SCOPED_TRACE(vector.name());
        const Filters filters = make_filters(vector.number("ppd"));
        const std::array images = {linear_image(vector.text("reference")),
                                   linear_image(vector.text("test"))};
        std::array<Stages, 2> stages;
        for (size_t i = 0; i < 2; ++i)
            stages[i] = make_stages(images[i], filters, 0, images[i].height);
        for (const json::Member& member : points.children()) {
            SCOPED_TRACE(member.value.pointer());
            expect_stages(member.value, images, stages);
            ++compared;
        }
    }
    EXPECT_GT(compared, 30U);
}

TEST(Flip, OfHighDynamicRangeIsThatOfTheOriginal) {
    for (const Vector& vector : vectors()) {
        if (!vector.is_hdr()) continue;
        SCOPED_TRACE(vector.name());
        const Image reference = linear_image(vector.text("reference"));
        const Tone tone = *tone_named(vector.text("tone_mapper"));
        Exposures exposures = exposures_of(reference, tone);
        if (vector.name().ends_with("given")) exposures = {-3, 2, 4};
        EXPECT_NEAR(exposures.start, vector.number("start_exposure"), 1e-5);
        EXPECT_NEAR(exposures.stop, vector.number("stop_exposure"), 1e-5);
        ASSERT_EQ(exposures.count, vector.number("exposures"));
        const HdrFlip result = hdr_flip(reference, linear_image(vector.text("test")), tone,
                                        exposures, vector.number("ppd"));
        expect_pooled(vector, result.errors);
        for (const json::Member& member : vector.expected.find("points").children()) {
            const auto [x, y] = position(member.value.find("at"));
            EXPECT_NEAR(from_top(result.exposures, x, y) * (exposures.count - 1),
                        member.value.find("exposure_index").as_number(), 1e-4);
        }
    }
}

TEST(Flip, GrayMapsAreThoseOfTheOriginal) {
    size_t maps = 0;
    for (const Vector& vector : vectors()) {
        if (!vector.expected.has("map")) continue;
        SCOPED_TRACE(vector.name());
        ++maps;
        Diagnostics diagnostics;
        const auto map = load_image(flip_folder + vector.text("map"), diagnostics);
        ASSERT_TRUE(map) << to_text(diagnostics);
        const Image errors = flip(linear_image(vector.text("reference")),
                                  linear_image(vector.text("test")), vector.number("ppd"));
        size_t differ = 0;
        for (size_t i = 0; i < errors.data.size(); ++i)  // half a step by rounding
            differ += std::abs(map->data[i * map->channels] - errors.data[i]) > 0.51F / 255;
        EXPECT_EQ(differ, 0U);
    }
    EXPECT_EQ(maps, 2U);
}

}  // namespace
}  // namespace wrinkle::test
