#include "maps/texels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace wrinkle::maps {

namespace {

void six_channels(const float* heights, const float* du, const float* dv, uint32_t count,
                  float* out) {
    for (uint32_t x = 0; x < count; ++x, out += 6) {
        const float ds = du[x], dt = -dv[x];
        out[0] = heights ? heights[x] : -1;  // as OpenImageIO writes it for normal maps
        out[1] = ds;
        out[2] = dt;
        out[3] = ds * ds;
        out[4] = dt * dt;
        out[5] = ds * dt;
    }
}

void second_moments(const float* du, const float* dv, uint32_t count, float* out) {
    for (uint32_t x = 0; x < count; ++x, out += 3) {
        out[0] = du[x] * du[x];
        out[1] = dv[x] * dv[x];
        out[2] = du[x] * dv[x];
    }
}

void encode_normals(float green, const float* slopes, size_t count, float* out) {
    for (size_t i = 0; i < count; ++i, slopes += 2, out += 3) {
        const float du = slopes[0], dv = slopes[1];
        const float half = 0.5f / std::sqrt(du * du + dv * dv + 1);
        out[0] = 0.5f - du * half;
        out[1] = 0.5f - green * dv * half;
        out[2] = 0.5f + half;
    }
}

}  // namespace

uint32_t mean_channels(Kind kind) {
    constexpr std::array<uint32_t, 5> counts = {1, 2, 2, 6, 3};  // by Kind
    return counts[static_cast<size_t>(kind)];
}

std::vector<std::string> file_channel_names(const Target& target, bool pairs) {
    if (target.kind == Kind::slopes)
        return {bumpslopes_channels.begin(), bumpslopes_channels.end()};
    if (target.kind == Kind::height) return channel_names(1, false);
    return channel_names(target.kind == Kind::derivative && pairs ? 2 : 3, false);
}

void mean_row(const Rows& rows, const Target& target, uint32_t y, float* out) {
    const uint32_t count = rows.width();
    if (target.kind == Kind::height) {
        std::copy_n(rows.heights(y), count, out);
        return;
    }
    thread_local std::vector<float> along_u, along_v;
    along_u.resize(count);
    along_v.resize(count);
    float *du = along_u.data(), *dv = along_v.data();
    rows.slopes(y, du, dv);
    if (target.per == Per::uv && target.kind != Kind::normal)
        multiply(du, static_cast<float>(count), dv, static_cast<float>(rows.height()), count);
    if (target.kind == Kind::moments) return second_moments(du, dv, count, out);
    if (target.kind == Kind::slopes) return six_channels(rows.heights(y), du, dv, count, out);
    for (uint32_t x = 0; x < count; ++x, out += 2) {
        out[0] = du[x];
        out[1] = dv[x];
    }
}

void encode(const Target& target, const Stored& stored, const float* means, size_t count,
            uint32_t channels, float* out) {
    if (target.kind == Kind::normal)
        return encode_normals(target.green == Green::dx ? -1.0f : 1.0f, means, count, out);
    const uint32_t from = mean_channels(target.kind);
    const bool integers = is_integer(target.type);
    for (size_t i = 0; i < count; ++i, means += from, out += channels)
        for (uint32_t c = 0; c < channels; ++c) {
            const float value = c < from ? means[c] : 0;  // a third channel is constant 0
            out[c] = integers ? (value - stored.offset) / stored.scale : value;
        }
}

}  // namespace wrinkle::maps
