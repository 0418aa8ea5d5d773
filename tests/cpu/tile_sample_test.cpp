// Tests that texture reads of complete tiles equal Texture::sample_lod<float>() of each lane bit by
// bit, for every texel format, wrap mode and instruction set.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "cpu/float_columns.h"
#include "cpu/support.h"

namespace wrinkle::test {
namespace {

constexpr size_t places = 700;

struct Picture {
    uint32_t width, height, channels;
    PixelType source;
    bool has_alpha = false;
    size_t levels = 99;
};

MipChain chain_of(const Picture& picture) {
    std::mt19937 random(picture.width * 31 + picture.channels);
    Image image = make_image(picture.width, picture.height, picture.channels, picture.source);
    image.has_alpha = picture.has_alpha;
    const bool bytes = picture.source == PixelType::u8;
    for (float& value : image.data)
        value = bytes ? static_cast<float>(random() % 256) / 255
                      : static_cast<float>(random() % 100000) / 777 - 50;
    MipChain chain = build_mips(std::move(image));
    // Coarser levels that may be read only if a lane lies between two levels.
    if (!bytes)
        for (size_t k = 1; k < chain.levels.size(); k += 2)
            for (float& value : chain.levels[k].data)
                value = std::numeric_limits<float>::infinity();
    chain.levels.resize(std::min(chain.levels.size(), picture.levels));
    return chain;
}

// u, v and lod: ordinary values, neighbours in a row, distant values, and non-finite values.
double coordinate(std::mt19937& random, size_t k) {
    constexpr double strange[] = {0,   1,   -1e-9, 1e9, -3e8,  infinity, -infinity,
                                  NAN, 0.5, -0.5,  2,   1e-40, 1 - 1e-8, 16777217};
    if (k % 5 == 0) return strange[random() % std::size(strange)];
    if (k < places / 2) return (static_cast<double>(k) + 0.5) / 37;
    return static_cast<double>(random() % 10000) / 2500 - 2;
}
double lod(std::mt19937& random, size_t k) {
    if (k % 7 == 0) return NAN;
    if (k < places / 3) return -1;
    return k < places / 2 ? 2 : static_cast<double>(random() % 1000) / 200 - 1;
}

// Equal bits; NaN payloads may differ.
bool same(float a, float b) {
    return (a != a && b != b) || std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b);
}

using Number = std::function<double(size_t)>;
struct Coordinates {
    Number u, v, lod;
};

void expect_as_alone(const Picture& picture, const TextureOptions& options, const char* lanes,
                     const Coordinates& points) {
    Scene s(places);
    const Id u = s.numbers(points.u), v = s.numbers(points.v), level = s.numbers(points.lod);
    const uint32_t resource = s.m.add_resource({"picture", "", options, {}});
    const Id uv = s.m.construct(Type::vec2_, {u, v});
    const Id texel = s.m.add(Op::sample_lod_, {uv, level}, resource);
    s.output(s.m.swizzle(texel, lanes));
    std::string why;
    const Program program = compile_program(s.m, why);
    const Texture texture(chain_of(picture), options);
    PlaneScratch scratch;
    for (const InstructionSet set : every_set()) {
        Columns columns(program, s.points);
        evaluate_planes(program, std::span(&texture, 1), columns.from(0), places, scratch, set);
        for (size_t k = 0; k < places; ++k) {
            std::array<float, 3> at;  // u, v, lod in the order of the inputs
            for (size_t i = 0; i < 3; ++i)
                at[i] = columns.inputs[i][k];
            const auto wanted = texture.sample_lod<float>(at[0], at[1], at[2]);
            for (size_t i = 0; lanes[i]; ++i)
                ASSERT_TRUE(
                    same(columns.outputs[i][k], wanted[std::string_view("xyzw").find(lanes[i])]))
                    << picture.channels << " channels, wrap " << static_cast<int>(options.wrap)
                    << ", set " << static_cast<int>(set) << ", " << lanes << " of point " << k
                    << " at " << at[0] << ", " << at[1] << ", lod " << at[2];
        }
    }
}

void expect_as_alone(const Picture& picture, const TextureOptions& options, const char* lanes) {
    std::mt19937 random(5);
    const Number anywhere = [&](size_t k) { return coordinate(random, k); };
    expect_as_alone(picture, options, lanes,
                    {anywhere, anywhere, [&](size_t k) { return lod(random, k); }});
}

TEST(TileSamples, EveryLaneIsAsByItself) {
    const Picture pictures[] = {{37, 5, 3, PixelType::u8},
                                {16, 16, 4, PixelType::u8, true},
                                {64, 32, 3, PixelType::u8, false, 1},
                                {1, 1, 3, PixelType::u8},
                                {13, 8, 1, PixelType::u8},
                                {13, 8, 2, PixelType::u8, true},
                                {9, 9, 1, PixelType::float32},
                                {9, 7, 2, PixelType::float32},
                                {8, 8, 2, PixelType::float32, true},
                                {5, 16, 3, PixelType::u16, false, 1},
                                {12, 3, 4, PixelType::half, true}};
    for (const Picture& picture : pictures)
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
            for (const char* lanes : {"x", "xyz", "xyzw", "y", "w"})
                expect_as_alone(picture, {Encoding::linear, wrap, Filter::linear}, lanes);
}

// Consecutive lanes advance by one texel, across borders, forwards and backwards; along v if the
// image is one texel wide.
TEST(TileSamples, NeighboursAreAsByThemselves) {
    const Picture pictures[] = {{37, 5, 3, PixelType::u8},      {8, 8, 3, PixelType::u8},
                                {1, 20, 3, PixelType::u8},      {37, 6, 1, PixelType::float32},
                                {300, 2, 1, PixelType::u16},    {9, 4, 1, PixelType::float32},
                                {1, 20, 1, PixelType::float32}, {200, 3, 3, PixelType::float32}};
    for (const Picture& picture : pictures) {
        const auto step = [&](size_t k, uint32_t size) {
            const double texel = k < places / 2 ? static_cast<double>(k) : -static_cast<double>(k);
            return (texel + 0.3) / size;
        };
        const Coordinates along = {[&](size_t k) { return step(k, picture.width); },
                                   [&](size_t k) {
                                       return picture.width == 1
                                                  ? step(k, picture.height)
                                                  : static_cast<double>(k / 40) * 0.21;
                                   },
                                   [](size_t) { return -1; }};
        for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
            for (const char* lanes : {"x", "xyz"})
                expect_as_alone(picture, {Encoding::linear, wrap, Filter::linear}, lanes, along);
    }
}

// The case of baking: all lanes read the same level.
TEST(TileSamples, OneLevelForAllIsThatOfEachByItself) {
    std::mt19937 random(6);
    const Number anywhere = [&](size_t k) { return coordinate(random, k); };
    const double lods[] = {-3, 0, 1, 1.25, 2, 2.999, 3.5, 4, 9, 1e30, NAN, infinity, -infinity};
    for (const Picture& picture :
         {Picture{16, 16, 3, PixelType::u8}, Picture{13, 8, 2, PixelType::u8, true},
          Picture{9, 7, 2, PixelType::float32}})
        for (const double each : lods)
            expect_as_alone(picture, {Encoding::linear, Wrap::repeat, Filter::linear}, "xyz",
                            {anywhere, anywhere, [&](size_t) { return each; }});
}

TEST(TileSamples, NearestTexelsToo) {
    expect_as_alone({13, 8, 3, PixelType::u8}, {Encoding::linear, Wrap::repeat, Filter::nearest},
                    "xyz");
}

// Every byte is decoded to the same quotient as in the loader.
TEST(TileSamples, EveryByteIsItsQuotient) {
    Image image = make_image(256, 1, 3, PixelType::u8);
    for (size_t k = 0; k < image.data.size(); ++k)
        image.data[k] = static_cast<float>(k / 3) / 255;
    Scene s(256);
    const Id u = s.numbers([](size_t k) { return (static_cast<double>(k) + 0.5) / 256; });
    const uint32_t resource = s.m.add_resource({"bytes", "", {}, {}});
    const Id uv = s.m.construct(Type::vec2_, {u, s.m.number(0.5)});
    s.output(s.m.swizzle(s.m.add(Op::sample_lod_, {uv, s.m.number(0)}, resource), "xyz"));
    std::string why;
    const Program program = compile_program(s.m, why);
    MipChain chain;
    chain.levels.push_back(std::move(image));
    const Texture texture(std::move(chain), {});
    ASSERT_NE(texture.texels().levels(Wrap::repeat)[0].packed, nullptr);
    PlaneScratch scratch;
    for (const InstructionSet set : every_set()) {
        Columns columns(program, s.points);
        evaluate_planes(program, std::span(&texture, 1), columns.from(0), 256, scratch, set);
        for (size_t k = 0; k < 256; ++k)
            for (const std::vector<float>& channel : columns.outputs)
                ASSERT_EQ(channel[k], static_cast<float>(k) / 255) << "byte " << k;
    }
}

}  // namespace
}  // namespace wrinkle::test
