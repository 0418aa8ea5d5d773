#include <algorithm>
#include <array>
#include <bit>

#include "cpu/tile.h"

namespace wrinkle {
namespace {

using Outputs = std::array<float*, 4>;

Outputs from_lane(const Outputs& out, size_t first) {
    return {out[0] + first, out[1] + first, out[2] + first, out[3] + first};
}

// Samples one level at some of the points; missing channels follow expand_texel().
void sample_one(const TexelLevel& level, Wrap wrap, const Kernels& kernels,
                const TileSample& sample) {
    const auto& out = sample.out;
    const auto stored = static_cast<size_t>(level.stored);
    const bool gray = stored == 1 || (stored == 2 && level.has_alpha);
    const size_t read = gray && sample.channels < 4 ? 1 : std::min(stored, sample.channels);
    Outputs to = out;
    if (gray && read == 2) to[1] = out[3];
    kernels.sample_level(level, wrap, read)(level, sample.u, sample.v, to.data(), sample.count);
    for (size_t c = 1; gray && c < std::min(sample.channels, size_t{3}); ++c)
        std::copy_n(out[0], sample.count, out[c]);
    if (stored == 2 && !gray && sample.channels > 2) std::fill_n(out[2], sample.count, 0.0F);
    const bool opaque = stored == 1 || stored == 3 || (stored == 2 && !gray);
    if (sample.channels == 4 && opaque) std::fill_n(out[3], sample.count, 1.0F);
}

// Level of each lane, and the interpolation weight of the next level.
struct Lods {
    std::array<float, tile_points> level, between;
};

void find_lods(const float* lod, size_t n, float last, Lods& found) {
    for (size_t k = 0; k < n; ++k) {
        const float above = lod[k] > 0 ? lod[k] : 0.0F;  // NaN reads level 0
        const float inside = above < last ? above : last;
        found.level[k] = static_cast<float>(static_cast<int32_t>(inside));
        found.between[k] = inside - found.level[k];
    }
}

// Returns true if all lods are equal, as when baking a map on the uv of its layout.
bool are_same(const float* lod, size_t n) {
    uint32_t other = 0;  // branch-free, so that the loop is vectorised
    for (size_t k = 0; k < n; ++k)
        other |= std::bit_cast<uint32_t>(lod[k]) ^ std::bit_cast<uint32_t>(lod[0]);
    return other == 0;
}

// Returns the first lane after `first` that reads another level.
size_t run_end(const Lods& lods, size_t first, size_t n) {
    size_t end = first + 1;
    while (end < n && lods.level[end] == lods.level[first])
        ++end;
    return end;
}

bool any_between(const Lods& lods, size_t first, size_t end) {
    uint32_t any = 0;  // branch-free, as above
    for (size_t k = first; k < end; ++k)
        any |= static_cast<uint32_t>(lods.between[k] > 0);
    return any != 0;
}

// Interpolates with the next level in the lanes that read it.
void mix_in(const TileSample& fine, const Outputs& coarse, const float* between) {
    for (size_t c = 0; c < fine.channels; ++c) {
        float* __restrict out = fine.out[c];
        const float* next = coarse[c];
        for (size_t k = 0; k < fine.count; ++k) {
            const float mixed = out[k] + (next[k] - out[k]) * between[k];
            out[k] = between[k] > 0 ? mixed : out[k];
        }
    }
}

// Samples lanes that read the same level, and the next one if required.
void sample_run(const Texture& texture, std::span<const TexelLevel> levels, const Kernels& kernels,
                const TileSample& run, const Lods& lods, size_t first) {
    const auto level = static_cast<size_t>(lods.level[first]);
    const Wrap wrap = texture.options().wrap;
    if (!any_between(lods, first, first + run.count))
        return sample_one(levels[level], wrap, kernels, run);
    TileSample coarse = run;
    std::array<std::array<float, tile_points>, 4> next;
    coarse.out = {next[0].data(), next[1].data(), next[2].data(), next[3].data()};
    sample_one(levels[level], wrap, kernels, run);
    sample_one(levels[level + 1], wrap, kernels, coarse);
    mix_in(run, coarse.out, &lods.between[first]);
}

}  // namespace

void sample_tile(const Texture& texture, const Kernels& kernels, const TileSample& sample) {
    const Wrap wrap = texture.options().wrap;
    const std::span<const TexelLevel> levels = texture.texels().levels(wrap);
    if (levels.size() == 1) return sample_one(levels[0], wrap, kernels, sample);
    const auto last = static_cast<float>(levels.size() - 1);
    Lods lods;
    if (are_same(sample.lod, sample.count)) {
        find_lods(sample.lod, 1, last, lods);
        const auto level = static_cast<size_t>(lods.level[0]);
        if (lods.between[0] == 0) return sample_one(levels[level], wrap, kernels, sample);
        std::fill_n(lods.between.begin(), sample.count, lods.between[0]);
        return sample_run(texture, levels, kernels, sample, lods, 0);
    }
    find_lods(sample.lod, sample.count, last, lods);
    for (size_t first = 0, end = 0; first < sample.count; first = end) {
        end = run_end(lods, first, sample.count);
        TileSample run = sample;
        run.u += first;
        run.v += first;
        run.out = from_lane(sample.out, first);
        run.count = end - first;
        sample_run(texture, levels, kernels, run, lods, first);
    }
}

}  // namespace wrinkle
