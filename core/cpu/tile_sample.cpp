#include "cpu/tile_sample.h"

#include <algorithm>
#include <array>

#include "base/transcendental.h"

namespace wrinkle {
namespace {

using Outputs = std::array<float*, 4>;

Outputs from_lane(const Outputs& out, size_t first) {
    return {out[0] + first, out[1] + first, out[2] + first, out[3] + first};
}

// What is read where: u and v begin with the first lane.
struct Places {
    const float* u;
    const float* v;
    size_t count;
};

// One level's channels, by the rule of expand_texel().
void sample_one(const TexelLevel& level, Wrap wrap, const Kernels& kernels, size_t channels,
                const Places& places, const Outputs& out) {
    const auto stored = static_cast<size_t>(level.stored);
    const bool gray = stored == 1 || (stored == 2 && level.has_alpha);
    const size_t read = gray && channels < 4 ? 1 : std::min(stored, channels);
    Outputs to = out;
    if (gray && read == 2) to[1] = out[3];
    kernels.sample_level(level, wrap, read)(level, places.u, places.v, to.data(), places.count);
    for (size_t c = 1; gray && c < std::min(channels, size_t{3}); ++c)
        std::copy_n(out[0], places.count, out[c]);
    if (stored == 2 && !gray && channels > 2) std::fill_n(out[2], places.count, 0.0F);
    const bool opaque = stored == 1 || stored == 3 || (stored == 2 && !gray);
    if (channels == 4 && opaque) std::fill_n(out[3], places.count, 1.0F);
}

// Which level each lane reads, and how far towards the next.
struct Lods {
    std::array<float, tile_lanes> level, between;
};

void find_lods(const float* lod, size_t n, float last, Lods& found) {
    for (size_t k = 0; k < n; ++k) {
        const float above = lod[k] > 0 ? lod[k] : 0.0F;  // NaN reads level 0
        const float inside = above < last ? above : last;
        found.level[k] = math::floor(inside);
        found.between[k] = inside - found.level[k];
    }
}

// The first lane behind `first` that reads another level.
size_t run_end(const Lods& lods, size_t first, size_t n) {
    size_t end = first + 1;
    while (end < n && lods.level[end] == lods.level[first])
        ++end;
    return end;
}

bool any_between(const Lods& lods, size_t first, size_t end) {
    bool any = false;
    for (size_t k = first; k < end; ++k)
        any |= lods.between[k] > 0;
    return any;
}

// The next level's values, where a lane reads them too.
void mix_in(const Outputs& fine, const Outputs& coarse, const float* between, size_t channels,
            size_t n) {
    for (size_t c = 0; c < channels; ++c) {
        float* __restrict out = fine[c];
        const float* next = coarse[c];
        for (size_t k = 0; k < n; ++k) {
            const float mixed = out[k] + (next[k] - out[k]) * between[k];
            out[k] = between[k] > 0 ? mixed : out[k];
        }
    }
}

}  // namespace

void sample_tile(const Texture& texture, const Kernels& kernels, size_t channels, const float* u,
                 const float* v, const float* lod, float* const* out, size_t n) {
    const Wrap wrap = texture.options().wrap;
    const std::span<const TexelLevel> levels = texture.texels().levels(wrap);
    const Outputs all{out[0], out[1], out[2], out[3]};
    if (levels.size() == 1) return sample_one(levels[0], wrap, kernels, channels, {u, v, n}, all);
    Lods lods;
    find_lods(lod, n, static_cast<float>(levels.size() - 1), lods);
    for (size_t first = 0, end = 0; first < n; first = end) {
        end = run_end(lods, first, n);
        const auto level = static_cast<size_t>(lods.level[first]);
        const Places places{u + first, v + first, end - first};
        const Outputs here = from_lane(all, first);
        sample_one(levels[level], wrap, kernels, channels, places, here);
        if (!any_between(lods, first, end)) continue;
        std::array<std::array<float, tile_lanes>, 4> next;
        const Outputs coarser{next[0].data(), next[1].data(), next[2].data(), next[3].data()};
        sample_one(levels[level + 1], wrap, kernels, channels, places, coarser);
        mix_in(here, coarser, &lods.between[first], channels, places.count);
    }
}

}  // namespace wrinkle
