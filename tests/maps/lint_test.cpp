// Tests of map lint: a correct map of each kind, and each defect added to one.
#include "maps/lint.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "image/writer.h"
#include "maps/measures.h"
#include "maps/support.h"
#include "support/files.h"

namespace wrinkle::maps {
namespace {

using namespace test;

// Has enough detail to show no banding in 8 bits.
const Waves detailed{64, 48, 3};

std::vector<std::string> defects_of(const Verdict& verdict) {
    std::vector<std::string> names;
    for (const Finding& finding : verdict.findings)
        if (finding.is_defect) names.emplace_back(name_of(finding.defect));
    return names;
}

void expect(const Image& image, MapClass look, const std::vector<std::string>& defects,
            Wrap wrap = Wrap::repeat) {
    const Verdict verdict = examine(image, wrap);
    EXPECT_EQ(name_of(verdict.map_class), name_of(look));
    EXPECT_EQ(defects_of(verdict), defects);
    EXPECT_EQ(verdict.has_defects(), !defects.empty());
}

template <typename Change>
Image changed(Image image, Change change) {
    for (size_t i = 0; i < image.data.size(); i += image.channels)
        change(&image.data[i]);
    return image;
}

Image turned_green(const Image& image) {
    return changed(image, [](float* t) { t[1] = 1 - t[1]; });
}

Image in_range(Image image) {
    const auto [low, high] = std::minmax_element(image.data.begin(), image.data.end());
    const float least = *low, range = *high - *low;
    for (float& value : image.data)
        value = (value - least) / range;
    return image;
}

TEST(Lint, HealthyMapsHaveNoDefect) {
    for (const PixelType type : {PixelType::u8, PixelType::u16, PixelType::float32}) {
        Image normals = normal_image(detailed), heights = in_range(height_image(detailed));
        for (Image* image : {&normals, &heights})
            if (type == PixelType::float32)
                image->source = type;
            else
                quantise(*image, type);
        expect(normals, MapClass::normal_gl, {});
        expect(turned_green(normals), MapClass::normal_dx, {});
        expect(heights, MapClass::height, {});
    }
}

// The result is the sign of a sum, so it does not depend on strength or noise.
TEST(Lint, GreenIsFoundInGentleSteepAndNoisyMaps) {
    for (const double strength : {0.05, 0.5, 5.0}) {
        const Image gl = normal_image({96, 96, strength});
        expect(gl, MapClass::normal_gl, {});
        expect(turned_green(gl), MapClass::normal_dx, {});
        uint32_t state = 7;
        const Image noisy = changed(gl, [&](float* t) {
            for (int c = 0; c < 3; ++c) {
                state = state * 1664525 + 1013904223;
                t[c] += (static_cast<float>(state >> 8) / 16777216.0f - 0.5f) * 0.004f;
            }
        });
        EXPECT_EQ(name_of(examine(noisy, Wrap::repeat).map_class), "normal_gl");
    }
}

TEST(Lint, RidgesAlongOneAxisDoNotTellGreen) {
    Image image = make_image(64, 64, 3, PixelType::u16);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const double slope = 0.6 * std::sin(2 * std::numbers::pi * x / 16);
            const double length = std::sqrt(1 + slope * slope);
            float* t = image.texel(x, y);
            t[0] = static_cast<float>(0.5 - slope / length / 2);
            t[1] = 0.5f;
            t[2] = static_cast<float>(0.5 + 0.5 / length);
        }
    expect(image, MapClass::normal, {});
    expect(changed(image, [](float* t) { t[0] = 0.5f, t[2] = 1; }), MapClass::normal, {});
}

TEST(Lint, UnsignedZ) {
    expect(changed(normal_image(detailed), [](float* t) { t[2] = 2 * t[2] - 1; }),
           MapClass::normal_gl, {"unsigned_z"});
    Image image = changed(normal_image(detailed), [](float* t) { t[2] = 2 * t[2] - 1; });
    quantise(image, PixelType::u8);
    expect(turned_green(image), MapClass::normal_dx, {"unsigned_z"});
}

TEST(Lint, AMeanThatLeans) {
    expect(changed(normal_image(detailed), [](float* t) { t[0] += 0.02f; }), MapClass::normal_gl,
           {"tilt"});
}

TEST(Lint, VectorsThatAreNotUnit) {
    expect(changed(normal_image(detailed),
                   [](float* t) {
                       for (int c = 0; c < 3; ++c)
                           t[c] = 0.5f + (t[c] - 0.5f) * 0.8f;
                   }),
           MapClass::normal_gl, {"length"});
}

// Values truncated instead of rounded, and values stored as 128 + 127 n.
TEST(Lint, TheMiddleTakenFor127Or128) {
    const auto stored = [](float value) { return value / 255; };
    const Image low = changed(normal_image(detailed, PixelType::u8), [&](float* t) {
        for (int c = 0; c < 3; ++c)
            t[c] = stored(std::floor(t[c] * 255));
    });
    expect(low, MapClass::normal_gl, {"offset"});
    const Image high = changed(normal_image(detailed, PixelType::u8), [&](float* t) {
        for (int c = 0; c < 3; ++c)
            t[c] = stored(std::min(255.0f, std::round(128 + 127 * (2 * t[c] - 1))));
    });
    expect(high, MapClass::normal_gl, {"offset"});
}

TEST(Lint, EightBitsInStairs) {
    Image height = in_range(height_image({512, 512, 1}));
    for (float& value : height.data)
        value = 0.4f + 0.2f * value;
    Image rounded = height;
    quantise(rounded, PixelType::u8);
    expect(rounded, MapClass::height, {"banding"});
    rounded.source = PixelType::u16;  // the same values in a file of more bits
    expect(rounded, MapClass::height, {"banding"});
    quantise(height, PixelType::u16);
    expect(height, MapClass::height, {});
    Image gentle = normal_image({512, 512, 1});
    quantise(gentle, PixelType::u8);
    expect(gentle, MapClass::normal_gl, {"banding"});
}

TEST(Lint, SeamsThatDoNotTile) {
    const Waves wide{96, 64, 3};
    const Image whole = in_range(height_image(wide));
    Image cut = make_image(77, 64, 1, PixelType::float32);
    for (uint32_t y = 0; y < 64; ++y)
        std::copy_n(whole.texel(0, y), 77, cut.texel(0, y));
    expect(cut, MapClass::height, {"seam_u"});
    expect(cut, MapClass::height, {}, Wrap::clamp);
    const Image normals = normal_image(wide);
    Image low = make_image(96, 41, 3, PixelType::u16);
    std::copy_n(normals.data.begin(), low.data.size(), low.data.begin());
    const auto defects = defects_of(examine(low, Wrap::repeat));
    EXPECT_NE(std::find(defects.begin(), defects.end(), "seam_v"), defects.end());
    EXPECT_EQ(std::find(defects.begin(), defects.end(), "seam_u"), defects.end());
}

// The waves within a strip at the left border; `background` fills the rest, as in an atlas.
Image strip_on(const Image& waves, const std::vector<float>& background) {
    Image image = waves;
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = image.width / 3; x < image.width; ++x)
            std::copy(background.begin(), background.end(), image.texel(x, y));
    return image;
}

TEST(Lint, AnAtlasNeedNotTile) {
    const Waves smooth{512, 384, 9};
    const Image normals = normal_image(smooth), heights = in_range(height_image(smooth));
    for (const Image& atlas : {strip_on(normals, {0.5F, 0.5F, 1}), strip_on(normals, {0, 0, 0}),
                               strip_on(heights, {0}), strip_on(heights, {0.5F})}) {
        const Verdict verdict = examine(atlas, Wrap::repeat);
        EXPECT_EQ(defects_of(verdict), std::vector<std::string>{});
        ASSERT_EQ(verdict.findings.size(), 1U);
        EXPECT_EQ(name_of(verdict.findings[0].defect), "seam_u");
        EXPECT_NE(verdict.findings[0].message.find("atlas"), std::string::npos);
    }
    // The normals fade to flat at the border of their island.
    Image faded = strip_on(normals, {0.5F, 0.5F, 1});
    for (uint32_t y = 0; y < faded.height; ++y)
        for (uint32_t x = 0; x < faded.width / 3; ++x)
            for (uint32_t c = 0; c < 2; ++c) {
                float& t = faded.texel(x, y)[c];
                t = 0.5F + (t - 0.5F) * std::min(1.0F, static_cast<float>(170 - x) / 100);
            }
    EXPECT_EQ(examine(faded, Wrap::repeat).measure("shore").value_or(9) < 4, true);
    EXPECT_EQ(defects_of(examine(faded, Wrap::repeat)), std::vector<std::string>{});
    // A plateau that the waves enter without a discontinuity is not a gap between islands.
    Image plateau = heights;
    for (float& value : plateau.data)
        value = std::max(value - 0.5F, 0.0F);
    Image cut = make_image(401, 384, 1, PixelType::float32);
    for (uint32_t y = 0; y < cut.height; ++y)
        std::copy_n(plateau.texel(0, y), cut.width, cut.texel(0, y));
    expect(cut, MapClass::height, {"seam_u"});
}

TEST(Lint, TheFileOfALayoutNeedNotTile) {
    const test::TemporaryFolder folder;
    const Waves smooth{512, 384, 9};
    const Image waves = in_range(height_image(smooth));
    const auto findings = [&](const std::vector<ImageNumber>& numbers) {
        WriterOptions options;
        options.width = 401;
        options.height = 384;
        options.channels = {"Y"};
        options.type = PixelType::u16;
        options.numbers = numbers;
        Diagnostics problems;
        const auto file = folder.path() / "height.png";
        auto writer = ImageWriter::open(file, options, problems);
        for (uint32_t y = 384; y-- > 0;)
            writer->write({waves.texel(0, y), 401}, problems);
        EXPECT_TRUE(writer->finish(problems)) << to_text(problems);
        return examine(file, Wrap::repeat, problems)->verdict;
    };
    EXPECT_EQ(defects_of(findings({})), std::vector<std::string>{"seam_u"});
    EXPECT_EQ(defects_of(findings({{layout_mark, 1}})), std::vector<std::string>{});
}

TEST(Lint, GreenOfRegionsThatDisagreeIsMixed) {
    const Waves waves{128, 96, 3};
    const Image up = normal_image(waves);
    Image mixed = turned_green(up);
    for (uint32_t y = 0; y < mixed.height; ++y)
        std::copy_n(up.texel(0, y), 3 * 48, mixed.texel(0, y));
    const Verdict verdict = examine(mixed, Wrap::repeat);
    EXPECT_LT(verdict.measure("curl_correlation").value_or(0), -0.1) << "one way on the whole";
    const auto defects = defects_of(verdict);
    EXPECT_NE(std::find(defects.begin(), defects.end(), "mixed"), defects.end());
    EXPECT_EQ(name_of(verdict.map_class), "normal");
    // One of 64 regions may differ.
    Image nearly = up;
    for (uint32_t y = 0; y < 12; ++y)
        for (uint32_t x = 0; x < 16; ++x)
            nearly.texel(x, y)[1] = 1 - nearly.texel(x, y)[1];
    EXPECT_EQ(name_of(examine(nearly, Wrap::repeat).map_class), "normal_gl");
}

TEST(Lint, AHeightOfOneValueIsNoted) {
    for (const uint32_t channels : {1u, 3u}) {
        Image flat = make_image(8, 8, channels, PixelType::u8);
        std::fill(flat.data.begin(), flat.data.end(), 0.25F);
        const auto notes = [](const Image& image) {
            std::vector<std::string> names;
            for (const Finding& finding : examine(image, Wrap::repeat).findings)
                if (!finding.is_defect) names.emplace_back(name_of(finding.defect));
            return names;
        };
        EXPECT_EQ(notes(flat).back(), "one_value");
        flat.data[0] = 0.5F;
        flat.data[channels - 1] = 0.5F;
        const auto names = notes(flat);
        EXPECT_EQ(std::count(names.begin(), names.end(), "one_value"), 0);
    }
}

TEST(Lint, AHeightInThreeChannelsIsAHeight) {
    const Image one = in_range(height_image(detailed));
    Image gray = make_image(one.width, one.height, 3, PixelType::u16);
    for (size_t i = 0; i < gray.data.size(); ++i)
        gray.data[i] = one.data[i / 3];
    const Verdict verdict = examine(gray, Wrap::repeat);
    EXPECT_EQ(name_of(verdict.map_class), "height");
    ASSERT_EQ(verdict.findings.size(), 1u);
    EXPECT_EQ(verdict.findings[0].defect, MapDefect::gray);
    EXPECT_FALSE(verdict.has_defects());
}

// The normals of a ball surrounded by black, as bakers leave it.
TEST(Lint, ObjectSpacePointsDownToo) {
    Image image = make_image(64, 64, 3, PixelType::u8);
    for (uint32_t y = 0; y < 64; ++y)
        for (uint32_t x = 0; x < 64; ++x) {
            const double a = 0.1 * x, b = 0.05 * y;
            if (x < 16) continue;
            image.texel(x, y)[0] = static_cast<float>(0.5 + 0.5 * std::cos(a) * std::sin(b));
            image.texel(x, y)[1] = static_cast<float>(0.5 + 0.5 * std::sin(a) * std::sin(b));
            image.texel(x, y)[2] = static_cast<float>(0.5 + 0.5 * std::cos(b));
        }
    expect(image, MapClass::normal_object, {});
}

TEST(Lint, TwoChannelsAndColors) {
    const Image normals = normal_image(detailed);
    Image two = make_image(64, 48, 2, PixelType::u16);
    for (size_t i = 0; i < two.data.size() / 2; ++i)
        std::copy_n(&normals.data[3 * i], 2, &two.data[2 * i]);
    expect(two, MapClass::two_channel, {});
    EXPECT_GT(examine(two, Wrap::repeat).measure("curl_correlation").value_or(0), 0.5);
    expect(changed(normals, [](float* t) { t[2] = 0; }), MapClass::two_channel, {});
    const auto gentle = [](float* t) {  // with blue as z, unit vectors that all point down
        t[0] = 0.5f + 0.1f * (t[0] - 0.5f);
        t[1] = 0.5f + 0.1f * (t[1] - 0.5f);
        t[2] = 0;
    };
    expect(changed(normals, gentle), MapClass::two_channel, {});
    Image colors = make_image(32, 32, 3, PixelType::u8);
    for (size_t i = 0; i < colors.data.size(); ++i)
        colors.data[i] = static_cast<float>(i * 7919 % 97) / 300 + (i % 3 == 0 ? 0.5f : 0.1f);
    expect(colors, MapClass::color, {});
}

// The evidence for a texture that repeats does not depend on the position of its border.
TEST(Lint, APictureThatRepeatsIsTheSameWhereverItIsCut) {
    const Image whole = normal_image(detailed);
    for (const auto& [right, up] : {std::pair(0u, 1u), {0u, 47u}, {1u, 0u}, {20u, 30u}}) {
        Image cut = whole;
        for (uint32_t y = 0; y < whole.height; ++y)
            for (uint32_t x = 0; x < whole.width; ++x)
                std::copy_n(whole.texel((x + right) % whole.width, (y + up) % whole.height), 3,
                            cut.texel(x, y));
        for (const bool made_z : {false, true}) {
            const auto measured = [&](Image image) {
                if (made_z)
                    for (size_t i = 2; i < image.data.size(); i += 3)
                        image.data[i] = 0;
                return examine(image, Wrap::repeat);
            };
            const Verdict a = measured(whole), b = measured(cut);
            ASSERT_EQ(a.evidence.size(), b.evidence.size());
            EXPECT_GT(a.measure("curl_dx").value_or(0), 0.01);
            for (size_t i = 0; i < a.evidence.size(); ++i) {
                const std::string& name = a.evidence[i].name;
                if (name.starts_with("seam") || name.ends_with("still")) continue;  // border only
                EXPECT_NEAR(a.evidence[i].value, b.evidence[i].value, 1e-9)
                    << name << " " << right << " " << up;
            }
        }
    }
}

// At a border that does not repeat, the filter mirrors the texture: the texture joined to its
// mirror image has no more curl than the texture itself.
TEST(Lint, ABorderThatClampsIsThatOfTheMirroredPicture) {
    const Image image = normal_image({64, 47, 3});
    Image twice = make_image(64, 94, 3, image.source);
    for (uint32_t y = 0; y < 94; ++y)
        for (uint32_t x = 0; x < 64; ++x)
            std::copy_n(image.texel(x, y < 47 ? y : 93 - y), 3, twice.texel(x, y));
    const auto curl = [](const Image& of) {
        const CurlMeasures measured = [&] {
            CurlSums sums(of.width, of.height, Wrap::clamp);
            for (uint32_t y = of.height; y-- > 0;)
                sums.add(of.texel(0, y), 3, 3);
            return sums.measures();
        }();
        // The mirrored half negates d/dv, and so swaps the two terms.
        return measured.gl * measured.gl + measured.dx * measured.dx;
    };
    EXPECT_NEAR(curl(image), curl(twice), 1e-9);
}

TEST(Lint, AFileIsWhatItsPictureIs) {
    const test::TemporaryFolder folder;
    Image image = normal_image(detailed);
    quantise(image, PixelType::u8);
    Diagnostics problems;
    const auto file = folder.path() / "normal.png";
    ASSERT_TRUE(save_image(image, file, {}, problems));
    const Verdict whole = examine(image, Wrap::repeat);
    const auto read = examine(file, Wrap::repeat, problems);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->info.width, 64u);
    EXPECT_EQ(read->verdict.map_class, whole.map_class);
    ASSERT_EQ(read->verdict.evidence.size(), whole.evidence.size());
    for (size_t i = 0; i < whole.evidence.size(); ++i)
        EXPECT_EQ(read->verdict.evidence[i].value, whole.evidence[i].value)
            << whole.evidence[i].name;
    EXPECT_FALSE(examine(file, Wrap::repeat, problems, [] { return true; }));
    EXPECT_TRUE(problems.list().empty());
    EXPECT_FALSE(examine(folder.path() / "none.png", Wrap::repeat, problems));
    EXPECT_EQ(problems.error_count(), 1u);
}

TEST(Lint, NanIsADefectAndOneTexelIsEnough) {
    Image image = make_image(1, 1, 1);
    expect(image, MapClass::height, {});
    image.data[0] = NAN;
    expect(image, MapClass::height, {"not_finite"});
    expect(make_image(1, 1, 3), MapClass::height, {});
}

}  // namespace
}  // namespace wrinkle::maps
