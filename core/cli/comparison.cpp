#include "cli/comparison.h"

#include <array>
#include <cstdio>

#include "base/printable.h"
#include "base/text.h"
#include "image/texels.h"
#include "report/measures.h"

namespace wrinkle::cli {
namespace {

constexpr std::array percentiles = {50, 90, 95, 99};

std::string six_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

std::string place_of_max(const report::Pooling& pooled) {
    return std::to_string(pooled.max_x()) + "," + std::to_string(pooled.max_y());
}

std::string unit_of(const Comparison& comparison) {
    return comparison.metric == "degrees" ? " degrees"
           : comparison.metric == "rms"   ? " 8-bit steps"
                                          : "";
}

std::string head_of(const Comparison& comparison) {
    std::string text = comparison.metric + ": " + std::to_string(comparison.map.width) + " x " +
                       std::to_string(comparison.map.height) + " pixels";
    if (comparison.metric == "flip")
        text += ", " + six_digits(comparison.pixels_per_degree) + " pixels per degree";
    if (!comparison.tone.empty()) {
        const report::Exposures& exposures = comparison.exposures;
        text += ", " + comparison.tone + ", " + std::to_string(exposures.count) +
                " exposures from " + six_digits(exposures.at(0)) + " to " +
                six_digits(exposures.at(exposures.count - 1)) + " EV";
    }
    return text + "\n";
}

std::string over_text(const report::Pooling& pooled, double over) {
    const uint64_t count = pooled.count_above(static_cast<float>(over));
    const double percent = 100.0 * static_cast<double>(count) / static_cast<double>(pooled.count());
    return "  above " + six_digits(over) + "  " + std::to_string(count) + " pixels, " +
           six_digits(percent) + " %\n";
}

std::string files_text(const Comparison& comparison) {
    std::string text;
    if (!comparison.map_file.empty())
        text += printable(comparison.map_file) + ": 0 to " + six_digits(comparison.scale) +
                unit_of(comparison) + "\n";
    if (!comparison.exposure_file.empty())
        text += printable(comparison.exposure_file) + ": " +
                six_digits(comparison.exposures.at(0)) + " to " +
                six_digits(comparison.exposures.at(comparison.exposures.count - 1)) + " EV\n";
    return text;
}

std::string member(const char* name, const std::string& value) {
    return json_quoted(name) + ": " + value;
}

std::string exposures_json(const Comparison& comparison) {
    const report::Exposures& exposures = comparison.exposures;
    return "{" + member("tone", json_quoted(comparison.tone)) + ", " +
           member("start", six_digits(exposures.at(0))) + ", " +
           member("stop", six_digits(exposures.at(exposures.count - 1))) + ", " +
           member("count", std::to_string(exposures.count)) + "}";
}

std::string percentiles_json(const report::Pooling& pooled) {
    return "{" +
           joined(percentiles, ", ",
                  [&](int percent) {
                      return member(std::to_string(percent).c_str(),
                                    six_digits(pooled.percentile(percent)));
                  }) +
           "}";
}

}  // namespace

std::string size_text(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

double mean_of(std::string_view metric, const report::Pooling& pooled) {
    return metric == "rms" ? pooled.root_mean_square() : pooled.mean();
}

void decode_loaded(Image& image) {
    if (is_integer(image.source)) decode_srgb(image);
}

Image map_of(std::string_view metric, Image reference, Image test, double pixels_per_degree) {
    if (metric == "rms") return report::steps_apart(reference, test);
    if (metric == "degrees") return report::degrees_apart(reference, test);
    decode_loaded(reference);
    decode_loaded(test);
    return report::flip(reference, test, pixels_per_degree);
}

std::vector<std::string> exceeded(const Comparison& comparison, const report::Pooling& pooled,
                                  const CompareLimits& limits) {
    std::vector<std::string> sentences;
    const auto hold = [&](const std::string& name, double value, std::optional<double> limit,
                          const char* option) {
        if (limit && !(value <= *limit))
            sentences.push_back(name + " " + six_digits(value) + " is above " + option + " " +
                                six_digits(*limit));
    };
    hold("the mean", mean_of(comparison.metric, pooled), limits.mean, "--max-mean");
    hold("pixel " + place_of_max(pooled) + " with", pooled.max(), limits.pixel, "--max-pixel");
    if (limits.max_over) {
        const uint64_t count = pooled.count_above(static_cast<float>(*limits.over));
        if (count > *limits.max_over)
            sentences.push_back(std::to_string(count) + " pixels above " +
                                six_digits(*limits.over) + " are more than --max-over " +
                                std::to_string(*limits.max_over));
    }
    if (!limits.any() && pooled.max() > 0)
        sentences.push_back(std::to_string(pooled.count_above(0)) + " pixels are above 0");
    return sentences;
}

std::string as_text(const Comparison& comparison, const report::Pooling& pooled,
                    const CompareLimits& limits) {
    std::string text = head_of(comparison);
    text += "  mean " + six_digits(mean_of(comparison.metric, pooled)) + unit_of(comparison) + "\n";
    text += "  weighted median " + six_digits(pooled.weighted_quantile(0.5)) + ", quartiles " +
            six_digits(pooled.weighted_quantile(0.25)) + " and " +
            six_digits(pooled.weighted_quantile(0.75)) + "\n  percentiles ";
    text += joined(percentiles, ", ", [&](int percent) {
        return std::to_string(percent) + ": " + six_digits(pooled.percentile(percent));
    });
    text += "\n  min " + six_digits(pooled.min()) + ", max " + six_digits(pooled.max()) + " at " +
            place_of_max(pooled) + " from the top left\n";
    if (limits.over) text += over_text(pooled, *limits.over);
    text += files_text(comparison);
    const auto sentences = exceeded(comparison, pooled, limits);
    return text + (sentences.empty() ? "same" : "different: " + joined(sentences, "; ")) + "\n";
}

std::string as_json(const Comparison& comparison, const report::Pooling& pooled,
                    const CompareLimits& limits) {
    const auto sentences = exceeded(comparison, pooled, limits);
    std::vector<std::string> members = {
        member("metric", json_quoted(comparison.metric)),
        member("width", std::to_string(comparison.map.width)),
        member("height", std::to_string(comparison.map.height)),
        member("mean", six_digits(mean_of(comparison.metric, pooled))),
        member("weighted_median", six_digits(pooled.weighted_quantile(0.5))),
        member("weighted_quartiles", "[" + six_digits(pooled.weighted_quantile(0.25)) + ", " +
                                         six_digits(pooled.weighted_quantile(0.75)) + "]"),
        member("percentiles", percentiles_json(pooled)),
        member("min", six_digits(pooled.min())),
        member("max", six_digits(pooled.max())),
        member("max_at", "[" + place_of_max(pooled) + "]")};
    if (comparison.metric == "flip")
        members.push_back(member("ppd", six_digits(comparison.pixels_per_degree)));
    if (!comparison.tone.empty())
        members.push_back(member("exposures", exposures_json(comparison)));
    if (limits.over)
        members.push_back(member(
            "over", "{" + member("limit", six_digits(*limits.over)) + ", " +
                        member("count", std::to_string(
                                            pooled.count_above(static_cast<float>(*limits.over)))) +
                        "}"));
    if (!comparison.map_file.empty())
        members.push_back(member("map", "{" + member("file", json_quoted(comparison.map_file)) +
                                            ", " + member("scale", six_digits(comparison.scale)) +
                                            "}"));
    members.push_back(member("same", sentences.empty() ? "true" : "false"));
    members.push_back(member("exceeded", "[" + joined(sentences, ", ", [](const std::string& each) {
                                             return json_quoted(each);
                                         }) + "]"));
    return "{" + joined(members, ", ") + "}\n";
}

}  // namespace wrinkle::cli
