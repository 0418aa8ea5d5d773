#include "maps/lint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "image/writer.h"
#include "maps/measures.h"

namespace wrinkle::maps {

namespace {

constexpr double certain_curl = 0.1;                    // minimum correlation that decides green
constexpr double leaning_degrees = 1.5;                 // tilt of the mean normal
constexpr double still_share = 0.6, step_share = 0.97;  // minimum shares of neighbours: banding
constexpr double seam_factor = 2;
constexpr double mixed_share = 0.15;  // minimum share of the curl, both signs
constexpr double min_background = 0.02, min_plain = 0.1, shore_factor = 4;
constexpr double good_z = 0.03;  // rms limit; covers 8-bit JPEG

struct NamedWords {
    std::string_view name, words;
};
constexpr std::array map_classes = {
    NamedWords{"height", "a height map"},
    NamedWords{"normal_gl", "a tangent-space normal map, green up"},
    NamedWords{"normal_dx", "a tangent-space normal map, green down"},
    NamedWords{"normal", "a tangent-space normal map, green up or down"},
    NamedWords{"normal_object", "an object-space normal map"},
    NamedWords{"two_channel", "slopes or normals in two channels"},
    NamedWords{"color", "no map of a bump"},
};
static_assert(map_classes.size() == static_cast<size_t>(MapClass::color) + 1);

constexpr std::array map_defects = {
    NamedWords{"tilt", "the bump leans to one side"},
    NamedWords{"unsigned_z", "blue holds z from 0 to 1, not from -1 to 1"},
    NamedWords{"length", "most of its vectors are not of length 1"},
    NamedWords{"offset", "its 8 bits lie half a step beside the middle"},
    NamedWords{"banding", "its 8 bits make stairs of slopes"},
    NamedWords{"mixed", "its green points up in some regions and down in others"},
    NamedWords{"seam_u", "it does not tile, but the texture repeats"},
    NamedWords{"seam_v", "it does not tile, but the texture repeats"},
    NamedWords{"gray", "its three channels hold one height"},
    NamedWords{"one_value", "it is the same height everywhere"},
    NamedWords{"not_finite", "it holds numbers that are not finite"},
    NamedWords{"unexpected", "it is not what it was to be"},
};
static_assert(map_defects.size() == static_cast<size_t>(MapDefect::unexpected) + 1);

template <typename... Values>
std::string text(const char* format, Values... values) {
    char buffer[256];
    std::snprintf(buffer, sizeof buffer, format, values...);
    return buffer;
}

bool is_normal(MapClass map_class) {
    return map_class == MapClass::normal || map_class == MapClass::normal_gl ||
           map_class == MapClass::normal_dx;
}

// Takes the rows of an image from the top, then examines its statistics.
class Examination {
public:
    Examination(const ImageInfo& info, Wrap wrap)
        : info_(info),
          wrap_(wrap),
          channels_(info.channels - (info.has_alpha ? 1 : 0)),
          curl_(info.width, info.height, wrap),
          made_curl_(info.width, info.height, wrap) {
        const uint32_t count = std::min(channels_, 2u);
        if (is_integer(info.source)) steps_.assign(count, StepSums(info.source));
        seams_.assign(count, SeamSums(info.width));
        islands_ = {IslandSums(IslandSums::Background::zero),
                    IslandSums(IslandSums::Background::middle)};
        if (channels_ >= 3) islands_.emplace_back(IslandSums::Background::normals);
    }

    void add(const float* row) {
        const uint32_t width = info_.width, channels = info_.channels;
        not_finite_ += static_cast<size_t>(std::count_if(
            row, row + size_t{width} * channels, [](float t) { return !std::isfinite(t); }));
        if (not_finite_ > 0) return;  // statistics of NaN are undefined
        if (channels_ >= 3) {
            vector_sums_.add(row, width, channels);
            curl_.add(row, channels, channels_);
        }
        if (channels_ >= 2) {
            made_curl_.add(row, channels, 2);
            if (info_.source == PixelType::u8) offset_.add(row, width, channels);
        }
        for (uint32_t channel = 0; channel < seams_.size(); ++channel)
            seams_[channel].add(row, channels, channel);
        for (IslandSums& islands : islands_)
            islands.add(row, width, channels);
        for (size_t i = 0; i < size_t{width} * channels; i += channels) {
            lowest_ = std::min(lowest_, row[i]);
            highest_ = std::max(highest_, row[i]);
        }
        for (uint32_t channel = 0; channel < steps_.size(); ++channel)
            steps_[channel].add(row, width, channels, channel);
    }

    // `is_layout`: the file is marked as a mesh layout. Precondition: all rows were added.
    Verdict run(bool is_layout) {
        if (!check_finite()) return verdict_;
        if (channels_ >= 3)
            classify_vectors();
        else
            verdict_.map_class = channels_ == 2 ? MapClass::two_channel : MapClass::height;
        if (is_normal(verdict_.map_class) || verdict_.map_class == MapClass::two_channel)
            check_green();
        if (is_normal(verdict_.map_class)) check_normals();
        if (verdict_.map_class == MapClass::height && lowest_ == highest_)
            find(MapDefect::one_value, "all of its texels hold one height", false);
        const bool relief = is_normal(verdict_.map_class) || verdict_.map_class == MapClass::height;
        if (relief) check_steps();
        if (relief) check_seams(is_layout);
        return verdict_;
    }

private:
    void measure(const char* name, double value) { verdict_.evidence.push_back({name, value}); }
    void find(MapDefect defect, std::string message, bool is_defect = true) {
        verdict_.findings.push_back({defect, std::move(message), is_defect});
    }

    double texels() const { return static_cast<double>(info_.width) * info_.height; }

    bool check_finite() {
        if (not_finite_ == 0) return true;
        verdict_.map_class = channels_ == 1 ? MapClass::height : MapClass::color;
        find(MapDefect::not_finite, text("%zu values are NaN or infinite", not_finite_));
        return false;
    }

    void classify_vectors() {
        vectors_ = vector_sums_.measures(texels());
        measure("empty", vectors_.empty);
        measure("gray", vectors_.gray);
        if (vectors_.gray > 0.995 || vectors_.empty == 1) {
            verdict_.map_class = MapClass::height;
            return find(MapDefect::gray, "three equal channels hold one height", false);
        }
        measure("unit", vectors_.unit);
        measure("downward", vectors_.downward);
        measure("mean_x", vectors_.mean[0]);
        measure("mean_y", vectors_.mean[1]);
        measure("mean_z", vectors_.mean[2]);
        const bool central = std::abs(vectors_.mean[0]) < 0.2 && std::abs(vectors_.mean[1]) < 0.2;
        const bool unit = vectors_.unit > 0.75;
        const bool flat_up = vectors_.unit >= 0.99 && vectors_.mean[2] > 0;
        if (vectors_.blue_spread < 1.5 * u8_step && !flat_up && central)
            verdict_.map_class = MapClass::two_channel;
        else if (unit && vectors_.downward > 0.02)
            verdict_.map_class = MapClass::normal_object;
        else if (unit || has_unsigned_z() || (central && vectors_.mean[2] > 0.3))
            verdict_.map_class = MapClass::normal;
        else
            verdict_.map_class = MapClass::color;
    }

    bool has_unsigned_z() const {
        return vectors_.between_z > 1.5 * u8_step && vectors_.unsigned_z < good_z &&
               vectors_.unsigned_z < 0.5 * vectors_.signed_z;
    }

    void check_green() {
        const bool made = verdict_.map_class == MapClass::two_channel || has_unsigned_z();
        const CurlMeasures curl = (made ? made_curl_ : curl_).measures();
        measure("curl_gl", curl.gl);
        measure("curl_dx", curl.dx);
        measure("curl_correlation", curl.correlation);
        if (verdict_.map_class != MapClass::normal) return;
        if (std::min(curl.regions_gl, curl.regions_dx) > mixed_share)
            return find(MapDefect::mixed,
                        text("green points up by %.0f %% of the slopes' curl and down "
                             "by %.0f %%, region by region",
                             100 * curl.regions_gl, 100 * curl.regions_dx));
        if (std::abs(curl.correlation) < certain_curl) return;
        verdict_.map_class = curl.correlation > 0 ? MapClass::normal_gl : MapClass::normal_dx;
    }

    void check_normals() {
        measure("signed_z", vectors_.signed_z);
        measure("unsigned_z", vectors_.unsigned_z);
        if (has_unsigned_z())
            find(MapDefect::unsigned_z,
                 text("blue is z from 0 to 1 within %.4f, and (1 + z) / 2 only "
                      "within %.4f",
                      vectors_.unsigned_z, vectors_.signed_z));
        else if (vectors_.unit <= 0.75)
            find(MapDefect::length,
                 text("only %.1f %% of the vectors have length 1 within 0.1", 100 * vectors_.unit));
        const auto& mean = vectors_.mean;
        const double tilt = std::atan2(std::hypot(mean[0], mean[1]), mean[2]) * 57.29577951308232;
        measure("tilt_degrees", tilt);
        if (tilt > leaning_degrees)
            find(MapDefect::tilt, text("the mean normal leans by %.2f degrees, (%.4f, %.4f, %.4f)",
                                       tilt, mean[0], mean[1], mean[2]));
        if (info_.source == PixelType::u8) check_offset();
    }

    // Detects an offset of half a step, equal in red and green.
    void check_offset() {
        const auto tilted = static_cast<double>(offset_.tilted), count = std::max(tilted, 1.0);
        const double red = offset_.red / count, green = offset_.green / count;
        measure("offset_red", red);
        measure("offset_green", green);
        const auto is_half = [](double steps) {
            return std::abs(steps) > 0.3 && std::abs(steps) < 0.8;
        };
        if (tilted / texels() < 0.01 || !is_half(red) || !is_half(green) ||
            std::abs(red - green) > 0.2)
            return;
        find(MapDefect::offset,
             text("red and green lie %+.2f and %+.2f steps of 255 beside 127.5: %d was "
                  "taken for the middle",
                  red, green, red > 0 ? 128 : 127));
    }

    void check_steps() {
        if (!is_integer(info_.source)) return;
        const uint32_t last = verdict_.map_class == MapClass::height ? 1 : 2;
        for (uint32_t channel = 0; channel < last; ++channel) {
            const StepMeasures steps = steps_[channel].measures();
            const std::string name = last == 1 ? "" : channel == 0 ? "red_" : "green_";
            measure((name + "levels").c_str(), static_cast<double>(steps.levels));
            measure((name + "still").c_str(), steps.still);
            const bool stairs = steps.levels > 4 && steps.still > still_share && steps.one > 0 &&
                                steps.still + steps.one > step_share;
            if (steps.eight_bits && steps.levels > 4)
                return find(
                    MapDefect::banding,
                    text("a file of 16 bits holds %zu values, all of 8 bits", steps.levels));
            if (stairs && info_.source == PixelType::u8)
                return find(MapDefect::banding,
                            text("%.1f %% of neighbours are equal and %.1f %% one level of 255 "
                                 "apart: slopes are stairs; 16 bits have none",
                                 100 * steps.still, 100 * steps.one));
        }
    }

    // Island edges are discontinuities, and so is the image's border. Around some islands normals
    // fade to flat; such images have a large flat share.
    bool is_atlas(const IslandMeasures& islands) const {
        const bool cut =
            islands.background > min_background && islands.shore > shore_factor * islands.inside;
        return cut || (is_normal(verdict_.map_class) && islands.plain > min_plain);
    }

    IslandMeasures islands() const {
        if (is_normal(verdict_.map_class)) return islands_.back().measures(texels());
        const IslandMeasures zero = islands_[0].measures(texels());
        const IslandMeasures middle = islands_[1].measures(texels());
        return zero.background > middle.background ? zero : middle;
    }

    SeamMeasures seam(uint32_t channels, bool across_u) const {
        const uint32_t length = across_u ? info_.height : info_.width;
        std::vector<double> sums(across_u ? info_.width : info_.height);
        for (uint32_t channel = 0; channel < channels; ++channel) {
            const std::vector<double> one =
                across_u ? seams_[channel].across_u() : seams_[channel].across_v();
            for (size_t line = 0; line < sums.size(); ++line)
                sums[line] += one[line] / (static_cast<double>(length) * channels);
        }
        const double border = sums.back();
        sums.pop_back();
        if (sums.empty()) return {};
        const auto percentile = sums.begin() + static_cast<ptrdiff_t>((sums.size() - 1) * 99 / 100);
        std::nth_element(sums.begin(), percentile, sums.end());
        return {border, *percentile};
    }

    void check_seams(bool is_layout) {
        const IslandMeasures islands = this->islands();
        const bool atlas = is_layout || is_atlas(islands);
        const uint32_t channels = verdict_.map_class == MapClass::height ? 1 : 2;
        for (const bool across_u : {true, false}) {
            const SeamMeasures seam = this->seam(channels, across_u);
            const MapDefect defect = across_u ? MapDefect::seam_u : MapDefect::seam_v;
            measure(name_of(defect).data(), seam.inside > 0 ? seam.border / seam.inside : 0);
            const double least = is_integer(info_.source) ? u8_step : 0;
            if (seam.border <= seam_factor * seam.inside || seam.border <= least) continue;
            if (!verdict_.measure("background")) {
                measure("background", islands.background);
                measure("shore", islands.inside > 0 ? islands.shore / islands.inside : 0);
                measure("plain", islands.plain);
            }
            find(defect,
                 text("across %s the border steps by %.4g where 99 of 100 %s inside step by "
                      "less than %.4g: it does not tile%s",
                      across_u ? "u" : "v", seam.border, across_u ? "columns" : "rows", seam.inside,
                      atlas ? ", as an atlas of islands need not" : ""),
                 wrap_ == Wrap::repeat && !atlas);
        }
    }

    ImageInfo info_;
    Wrap wrap_;
    uint32_t channels_;  // without alpha
    size_t not_finite_ = 0;
    VectorSums vector_sums_;
    CurlSums curl_, made_curl_;    // with z from blue, and reconstructed from red and green
    OffsetSums offset_;            // 8-bit images only
    std::vector<StepSums> steps_;  // red and green, as seams_
    std::vector<SeamSums> seams_;
    std::vector<IslandSums> islands_;                // two for heights, one for normals
    float lowest_ = INFINITY, highest_ = -INFINITY;  // in the first channel
    Verdict verdict_;
    VectorMeasures vectors_;
};

}  // namespace

std::string_view name_of(MapClass map_class) {
    return map_classes[static_cast<size_t>(map_class)].name;
}

std::string_view description_of(MapClass map_class) {
    return map_classes[static_cast<size_t>(map_class)].words;
}

std::string_view name_of(MapDefect defect) {
    return map_defects[static_cast<size_t>(defect)].name;
}

std::string_view words_of(MapDefect defect) {
    return map_defects[static_cast<size_t>(defect)].words;
}

bool Verdict::has_defects() const {
    return std::ranges::any_of(findings, &Finding::is_defect);
}

std::optional<double> Verdict::measure(std::string_view name) const {
    for (const Measure& measure : evidence)
        if (measure.name == name) return measure.value;
    return {};
}

Verdict examine(const Image& image, Wrap wrap) {
    Examination examination(
        {"", image.width, image.height, image.channels, image.has_alpha, image.source}, wrap);
    for (uint32_t y = image.height; y-- > 0;)
        examination.add(image.texel(0, y));
    return examination.run(false);
}

std::optional<ExaminedFile> examine(const std::filesystem::path& file, Wrap wrap,
                                    Diagnostics& diagnostics,
                                    const std::function<bool()>& stopped) {
    std::optional<Examination> examination;
    const auto take = [&](const ImageInfo& info, const float* row) {
        if (stopped && stopped()) return false;
        if (!examination) examination.emplace(info, wrap);
        examination->add(row);
        return true;
    };
    const auto info = read_image_rows(file, take, diagnostics);
    if (!info) return {};
    const bool is_layout = read_image_number(file, layout_mark).has_value();
    return ExaminedFile{*info, examination->run(is_layout)};
}

}  // namespace wrinkle::maps
