// Result of `wrinkle compare`: the map of a measure, its limits, and how they are printed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "report/flip.h"
#include "report/pooling.h"

namespace wrinkle::cli {

// Values above which two images are different. If none is given, any difference is.
struct CompareLimits {
    std::optional<double> mean, pixel;
    std::optional<double> over;        // the count is that of pixels above this value
    std::optional<uint64_t> max_over;  // needs `over`

    bool any() const { return mean || pixel || max_over; }
};

struct Comparison {
    std::string metric;            // flip, degrees or rms
    Image map;                     // the measure per pixel
    double scale = 1;              // value with the last color of the written map
    double pixels_per_degree = 0;  // flip only
    std::string tone;              // HDR-FLIP only, else ""
    report::Exposures exposures;
    Image exposure_map;
    std::string map_file, exposure_file;  // written files, else ""
};

inline constexpr std::array image_metrics = {"rms", "flip", "degrees"};

std::string size_text(const Image& image);  // "640 x 480"

// Mean of the map of a metric; of `rms` the root mean square over all pixels.
double mean_of(std::string_view metric, const report::Pooling& pooled);

// Decodes an image as loaded: integers are sRGB, floats are linear.
void decode_loaded(Image& image);

// Returns the map of a metric of two images as loaded, of one size. For HDR-FLIP see report/flip.h.
Image map_of(std::string_view metric, Image reference, Image test,
             double pixels_per_degree = report::default_pixels_per_degree);

// Returns one sentence per exceeded limit; empty if the images are the same within the limits.
std::vector<std::string> exceeded(const Comparison& comparison, const report::Pooling& pooled,
                                  const CompareLimits& limits);

// `pooled` is that of the map.
std::string as_text(const Comparison& comparison, const report::Pooling& pooled,
                    const CompareLimits& limits);
std::string as_json(const Comparison& comparison, const report::Pooling& pooled,
                    const CompareLimits& limits);

}  // namespace wrinkle::cli
