// Tests of encodings on constants: add() folds them, so that the numbers can be read directly.
#include "lower/sampling.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace wrinkle {
namespace {

using Vec4 = std::array<double, 4>;

Vec4 decoded(Encoding encoding, const Vec4& texel, SrgbDecoder srgb = SrgbDecoder::shader) {
    Module m;
    const Id value =
        decode(m, {encoding, Wrap::repeat, Filter::linear, srgb}, m.constant(Type::vec4_, texel));
    EXPECT_TRUE(m.is_constant(value));
    Vec4 lanes{};
    for (size_t i = 0; i < 4; ++i)
        lanes[i] = m[m.operands(value)[i]].value;
    return lanes;
}

void expect_near(const Vec4& a, const Vec4& b) {
    for (size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(a[i], b[i], 1e-6) << "lane " << i;
}

TEST(Decode, LinearIsAsStored) {
    expect_near(decoded(Encoding::linear, {-2, 0.25, 7, 0.5}), {-2, 0.25, 7, 0.5});
}

TEST(Decode, SrgbByKnownValues) {
    // 188/255 is the well-known half of linear light; 0.5 is 0.21404; the linear segment is
    // c/12.92.
    expect_near(decoded(Encoding::srgb, {188 / 255.0, 0.5, 0.0129200, 0.5}),
                {0.5028865, 0.2140411, 0.001, 0.5});
    expect_near(decoded(Encoding::srgb, {0, 1, -0.01292, 1}), {0, 1, -0.001, 1});
    const Vec4 linear{0.2, 0.5, 0.8, 0.5};
    expect_near(decoded(Encoding::srgb, linear, SrgbDecoder::sampler), linear);
}

TEST(Decode, NormalsOfBothConventions) {
    expect_near(decoded(Encoding::normal_gl, {0.75, 0.25, 1, 0.5}), {0.5, -0.5, 1, 0.5});
    expect_near(decoded(Encoding::normal_dx, {0.75, 0.25, 1, 0.5}), {0.5, 0.5, 1, 0.5});
    expect_near(decoded(Encoding::derivative, {0.75, 0.25, 0, 1}), {0.5, -0.5, -1, 1});
}

TEST(Decode, TwoChannelNormalsAreUnit) {
    // (0.6, 0, 0.8), and z = 0 outside of the unit circle.
    expect_near(decoded(Encoding::normal_rg, {0.8, 0.5, 0.3, 0.1}), {0.6, 0, 0.8, 1});
    expect_near(decoded(Encoding::normal_rg, {1, 1, 0, 0}), {1, 1, 0, 1});
    // DXT5nm: red 1, x in alpha. A file with two channels: x in red, alpha 1.
    expect_near(decoded(Encoding::normal_ag, {1, 0.5, 0, 0.8}), {0.6, 0, 0.8, 1});
    expect_near(decoded(Encoding::normal_ag, {0.8, 0.5, 0, 1}), {0.6, 0, 0.8, 1});
}

TEST(Decode, PoisonStaysPoison) {
    Module m;
    EXPECT_EQ(decode(m, {Encoding::srgb}, poison), poison);
    EXPECT_TRUE(m.problems.empty());
}

}  // namespace
}  // namespace wrinkle
