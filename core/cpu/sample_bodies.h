// Bilinear sampling of one level: one loop per wrap mode, number of channels and storage format;
// see kernels.h. The arithmetic is that of Texture::sample_lod<float>().
#ifndef WRINKLE_ISA
#error "say for which instruction set: define WRINKLE_ISA"
#endif

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include "base/transcendental.h"
#include "cpu/kernels.h"
#include "cpu/wrap.h"

namespace wrinkle::WRINKLE_ISA {
namespace {

#include "cpu/vectors.h"

#define WRINKLE_INLINE [[gnu::always_inline]] inline

// Index of the texel at or below a coordinate (-1 is possible), and the weight of the next texel.
struct Below {
    Ints texel;
    Floats weight;
};

// wrapped() of wrap.h, then texel index and weight of the bilinear filter. Floats of large
// magnitude are integers, so `repeat` needs no range check.
template <Wrap wrap>
WRINKLE_INLINE Below below(Floats x, float size) {
    Floats at = x;
    if constexpr (wrap == Wrap::repeat) {
        at = above_zero(at - floor_of(at));
    } else {
        const Floats zero{}, one = zero + 1.0F;
        at = ((at < 1e9F) & (at > -1e9F)) ? at : zero;
        if constexpr (wrap == Wrap::clamp) {
            at = above_zero(at);
            at = at > 1.0F ? one : at;
        } else {
            at = at - 2.0F * floor_of(at / 2.0F);
            at = at > 1.0F ? 2.0F - at : at;
        }
    }
    at = at * size - 0.5F;
    const Whole whole = floor_to_int(at);
    return {whole.number, at - whole.same};
}

WRINKLE_INLINE Floats mixed(const Floats (&corner)[4], Floats x, Floats y) {
    const Floats low = corner[0] + (corner[1] - corner[0]) * x;
    const Floats high = corner[2] + (corner[3] - corner[2]) * x;
    return low + (high - low) * y;
}

// Corner texels of a TexelLevel::packed level.
struct Packed {
    Ints texel[4];

    // `near`: tries to load the corners as neighbours; set to false if that fails. bilinear() sets
    // it again every few vectors.
    template <Wrap wrap>
    WRINKLE_INLINE static Packed at(const TexelLevel& level, Ints i, Ints j, bool& near) {
        const int32_t row = level.width + 2;
        const uint32_t* low = level.packed + row + 1;  // texel (0, 0)
        const uint32_t* high = low + row;
        const Ints index = j * row + i;
        // Neighbouring texels, e.g. when baking a map at its own resolution: one contiguous load
        // and a permutation.
        for (const size_t end : {size_t{0}, vector_lanes - 1}) {
            if (!near) break;
            const int32_t start = index[end];
            const Ints lane = index - start;
            if (!are_lanes(lane)) continue;
            const auto row_at = [&](const uint32_t* from) {
                return permute(load<Ints>(from + start), lane);
            };
            return {{row_at(low), row_at(low + 1), row_at(high), row_at(high + 1)}};
        }
        near = false;
        return {{gather(low, index), gather(low + 1, index), gather(high, index),
                 gather(high + 1, index)}};
    }

    // Computes byte / 255 to the last bit without a division: three times a byte is exact, and its
    // product with the float nearest to 1 / 765 rounds as the quotient does (a test checks all
    // bytes).
    template <int channel>
    WRINKLE_INLINE Floats value(size_t corner) const {
        constexpr float of_765 = 0x1.56ac02p-10F;
        constexpr int shift = packed_shift[channel];
        if constexpr (channel == 2) {
            const Words top = reinterpret_cast<Words>(texel[corner]) >> shift;
            return to_floats(reinterpret_cast<Ints>(top)) * of_765;
        } else {
            return scaled(texel[corner] & (1023 << shift), of_765 / (1 << shift));
        }
    }
};

// Corner texels of a TexelLevel::floats level.
struct Stored {
    const float* floats;
    Ints index[4];

    template <Wrap wrap>
    WRINKLE_INLINE static Stored at(const TexelLevel& level, Ints i, Ints j, bool&) {
        const Ints zero{};
        const auto first = [&](Ints texel, int32_t size) {
            const Ints edge = zero + (wrap == Wrap::repeat ? size - 1 : 0);
            return texel < 0 ? edge : texel;
        };
        const auto second = [&](Ints texel, int32_t size) {
            const Ints edge = zero + (wrap == Wrap::repeat ? 0 : size - 1);
            return texel + 1 >= size ? edge : texel + 1;
        };
        const int32_t row = level.width * level.stored;
        const Ints low = first(j, level.height) * row, high = second(j, level.height) * row;
        const Ints left = first(i, level.width) * level.stored,
                   right = second(i, level.width) * level.stored;
        return {level.floats, {low + left, low + right, high + left, high + right}};
    }

    template <int channel>
    WRINKLE_INLINE Floats value(size_t corner) const {
        return reinterpret_cast<Floats>(gather(floats + channel, index[corner]));
    }
};

// Corner texels of a TexelLevel::floats level with one channel; neighbours are loaded as in Packed.
struct Single {
    Floats corner[4];

    template <Wrap wrap>
    WRINKLE_INLINE static Single at(const TexelLevel& level, Ints i, Ints j, bool& near) {
        const Stored far = Stored::at<wrap>(level, i, j, near);
        const float* floats = far.floats;
        const auto& index = far.index;
        for (const size_t end : {size_t{0}, vector_lanes - 1}) {
            if (!near) break;
            const int32_t low = index[0][end], high = index[2][end];
            const Ints lane = index[0] - low;
            const Ints other = ((index[2] - high) != lane) | (index[1] - index[0] != 1);
            const int32_t last = (low < high ? high : low) + static_cast<int32_t>(vector_lanes);
            if (last >= level.width * level.height || !are_lanes(lane | other)) continue;
            const auto row_at = [&](const float* from) {
                return reinterpret_cast<Floats>(permute(load<Ints>(from), lane));
            };
            return {{row_at(floats + low), row_at(floats + low + 1), row_at(floats + high),
                     row_at(floats + high + 1)}};
        }
        near = false;
        const auto one = [&](Ints at) { return reinterpret_cast<Floats>(gather(floats, at)); };
        return {{one(index[0]), one(index[1]), one(index[2]), one(index[3])}};
    }

    template <int>
    WRINKLE_INLINE Floats value(size_t number) const {
        return corner[number];
    }
};

template <int channel, class Corners>
WRINKLE_INLINE void put(const Corners& corners, Floats x, Floats y, float* out) {
    const Floats corner[] = {corners.template value<channel>(0), corners.template value<channel>(1),
                             corners.template value<channel>(2),
                             corners.template value<channel>(3)};
    store(out, mixed(corner, x, y));
}

template <Wrap wrap, int channels, class Corners>
WRINKLE_INLINE void vector(const TexelLevel& level, const float* u, const float* v,
                           float* const* out, size_t k, bool& near) {
    const Below i = below<wrap>(load<Floats>(u + k), static_cast<float>(level.width));
    const Below j = below<wrap>(load<Floats>(v + k), static_cast<float>(level.height));
    const auto corners = Corners::template at<wrap>(level, i.texel, j.texel, near);
    put<0>(corners, i.weight, j.weight, out[0] + k);
    if constexpr (channels > 1) put<1>(corners, i.weight, j.weight, out[1] + k);
    if constexpr (channels > 2) put<2>(corners, i.weight, j.weight, out[2] + k);
    if constexpr (channels > 3) put<3>(corners, i.weight, j.weight, out[3] + k);
}

template <Wrap wrap, int channels, class Corners>
void bilinear(const TexelLevel& of, const float* u, const float* v, float* const* to, size_t n) {
    // Local copies, which the stores below cannot alias.
    const TexelLevel level = of;
    float* const out[] = {to[0], to[1], to[2], to[3]};
    size_t k = 0;
    bool near = true;
    for (; k + vector_lanes <= n; k += vector_lanes) {
        near = near || k % 64 == 0;
        vector<wrap, channels, Corners>(level, u, v, out, k, near);
    }
    if (k == n) return;
    // The arrays end at lane n: the remaining lanes are processed in local buffers.
    float uvs[2][vector_lanes] = {}, values[4][vector_lanes];
    float* const rest[] = {values[0], values[1], values[2], values[3]};
    __builtin_memcpy(uvs[0], u + k, (n - k) * sizeof(float));
    __builtin_memcpy(uvs[1], v + k, (n - k) * sizeof(float));
    vector<wrap, channels, Corners>(level, uvs[0], uvs[1], rest, 0, near);
    for (size_t c = 0; c < static_cast<size_t>(channels); ++c)
        __builtin_memcpy(out[c] + k, values[c], (n - k) * sizeof(float));
}

template <Wrap wrap>
SampleLevel of_channels(const TexelLevel& level, size_t channels) {
    if (level.packed) return channels == 1 ? bilinear<wrap, 1, Packed> : bilinear<wrap, 3, Packed>;
    if (level.stored == 1) return bilinear<wrap, 1, Single>;
    constexpr SampleLevel stored[] = {bilinear<wrap, 1, Stored>, bilinear<wrap, 2, Stored>,
                                      bilinear<wrap, 3, Stored>, bilinear<wrap, 4, Stored>};
    return stored[channels - 1];
}

SampleLevel sample_level(const TexelLevel& level, Wrap wrap, size_t channels) {
    return with_wrap(wrap, [&](auto mode) { return of_channels<mode.value>(level, channels); });
}

#undef WRINKLE_INLINE

}  // namespace
}  // namespace wrinkle::WRINKLE_ISA
