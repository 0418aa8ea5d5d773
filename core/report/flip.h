// FLIP: the difference between two images that an observer sees when one replaces the other on a
// display, per pixel in [0, 1]. docs/compare.md has a summary.
//
// Sources: Andersson et al. 2020, "FLIP: A Difference Evaluator for Alternating Images" (LDR-FLIP;
// HPG 2020); Andersson et al. 2021, "Visualizing Errors in Rendered High Dynamic Range Images"
// (HDR-FLIP; Eurographics 2021). Constants are those of version 1.6 of NVIDIA's implementation.
//
// Images are linear RGB (Rec. 709 primaries, D65); one and two channels are expanded by
// expand_texel(), alpha is ignored. Precondition of all functions: equal sizes, at least one pixel,
// finite values. Thread-safe; they use all cores.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "image/image.h"

namespace wrinkle::report {

// A display 0.7 m wide with 3840 pixels, seen from 0.7 m: 3840 pi / 180.
inline constexpr double default_pixels_per_degree = 67.02064327658226;
inline constexpr double min_pixels_per_degree = 1, max_pixels_per_degree = 1000;

// LDR-FLIP. Values are clamped to [0, 1]. Returns one channel. Symmetric in its images.
Image flip(const Image& reference, const Image& test, double pixels_per_degree);

enum class Tone : uint8_t { aces, hable, reinhard };
inline constexpr std::array tone_names = {"aces", "hable", "reinhard"};
std::optional<Tone> tone_named(std::string_view name);

// Exposures in EV: start + i (stop - start) / (count - 1); `start` if the count is 1.
struct Exposures {
    double start = 0, stop = 0;
    uint32_t count = 1;

    double at(uint32_t i) const {
        return count < 2 ? start : start + i * (stop - start) / (count - 1);
    }
};
inline constexpr uint32_t max_exposures = 32;

// Returns the exposures at which the tone mapper makes 0.85 of the largest luminance (start) and of
// the median luminance (stop): ceil(stop - start) of them, 2 to max_exposures. A median of 0, for
// example of a black background, would make `stop` infinite: it is replaced by the median of the
// luminances above 0. A black image has the single exposure 0.
Exposures exposures_of(const Image& reference, Tone tone);

// HDR-FLIP: the maximum of LDR-FLIP over the exposures. Negative values are 0. Not symmetric if the
// exposures are those of the reference.
struct HdrFlip {
    Image errors;     // one channel
    Image exposures;  // i / (count - 1) of the first exposure with that error
};
HdrFlip hdr_flip(const Image& reference, const Image& test, Tone tone, const Exposures& exposures,
                 double pixels_per_degree);

}  // namespace wrinkle::report
