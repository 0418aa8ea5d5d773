#include "bench/texels/job.h"

#include <cmath>

namespace wrinkle::bench {
namespace {

constexpr float step = 1.0F / side;

uint32_t hashed(uint32_t x) {
    x = (x ^ x >> 16) * 0x7feb352dU;
    x = (x ^ x >> 15) * 0x846ca68bU;
    return x ^ x >> 16;
}

// A normal per texel, up to 40 degrees from +z, packed in four bytes.
uint32_t normal_texel(uint32_t seed) {
    const float angle = static_cast<float>(hashed(seed) & 0xFFFF) * (6.2831853F / 65536);
    const float sine = 0.64F * static_cast<float>(hashed(seed) >> 16) / 65536;
    const float normal[] = {sine * std::cos(angle), sine * std::sin(angle),
                            std::sqrt(1 - sine * sine)};
    uint32_t packed = 255U << 24;
    for (uint32_t k = 0; k < 3; ++k)
        packed |= static_cast<uint32_t>(std::lround((normal[k] * 0.5F + 0.5F) * 255)) << (8 * k);
    return packed;
}

std::vector<uint32_t> normals(uint32_t seed) {
    std::vector<uint32_t> texels(texel_count);
    for (uint32_t k = 0; k < texel_count; ++k)
        texels[k] = normal_texel(seed + k);
    return texels;
}

MipChain one_level(const std::vector<uint32_t>& texels) {
    MipChain chain;
    Image& image = chain.levels.emplace_back(make_image(side, side, 4, PixelType::u8));
    for (size_t k = 0; k < image.data.size(); ++k)
        image.data[k] = static_cast<float>(texels[k / 4] >> (8 * (k % 4)) & 0xFF) / 255;
    return chain;
}

Textures make_textures() {
    Textures made{{}, {}, normals(0x12345678), normals(0x9abcdef0)};
    made.base = one_level(made.rgba_base);
    made.detail = one_level(made.rgba_detail);
    return made;
}

}  // namespace

const Frame& frame() {
    static const Frame values{{{0.1F, 0.2F * step, -0.1F * step},
                               {-0.2F, 0.1F * step, 0.3F * step},
                               {1.1F, -0.2F * step, 0.1F * step}},
                              {{0.9F, 0.1F * step, 0.1F * step},
                               {0.1F, -0.2F * step, 0.1F * step},
                               {-0.1F, 0.1F * step, -0.1F * step}},
                              {{0.5F * step, step, 0}, {0.5F * step, 0, step}}};
    return values;
}

const Textures& textures() {
    static const Textures made = make_textures();
    return made;
}

std::string graph_text() {
    const auto number = [](float value) { return std::to_string(static_cast<double>(value)); };
    return R"({"wrinkle": 1, "nodes": {
        "base": {"type": "tangent_normal_map", "in": {"image": "textures/rivets_normal.png"}},
        "tile": {"type": "uv_transform", "in": {"scale": [)" +
           number(tiling) + ", " + number(tiling) + R"(], "offset": [)" + number(offset_u) + ", " +
           number(offset_v) + R"(]}},
        "detail": {"type": "tangent_normal_map",
                   "in": {"image": "textures/weave_normal.png", "uv": {"from": "tile.uv"}}},
        "softer": {"type": "gradient_scale",
                   "in": {"gradient": {"from": "detail.gradient"}, "amount": )" +
           number(amount) + R"(}},
        "sum": {"type": "gradient_add",
                "in": {"a": {"from": "base.gradient"}, "b": {"from": "softer.gradient"}}},
        "normal": {"type": "resolve", "in": {"gradient": {"from": "sum.gradient"}}}},
        "outputs": {"normal": {"from": "normal.normal"}}})";
}

}  // namespace wrinkle::bench
