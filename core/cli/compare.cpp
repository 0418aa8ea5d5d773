// wrinkle compare A B: measures the difference of two images and holds it to limits.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/file.h"
#include "cli/arguments.h"
#include "cli/cli.h"
#include "cli/comparison.h"
#include "cli/output.h"
#include "image/load.h"
#include "report/colormap.h"
#include "report/measures.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

bool is_map_name(const std::string& file) {
    const std::string extension = fs::path(file).extension().string();
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg" ||
           extension == ".tif" || extension == ".tiff" || extension == ".exr";
}

// Returns std::nullopt and reports an error if the image is unreadable or has NaN or infinite
// values.
std::optional<Image> load_finite(const std::string& file, Diagnostics& diagnostics) {
    Diagnostics loading;
    auto image = load_image(file, loading);
    const bool finite =
        image && std::ranges::all_of(image->data, [](float value) { return std::isfinite(value); });
    for (Diagnostic each : loading.list()) {
        if (image && !finite) {
            each.severity = Severity::error;
            each.expected = "finite values in both images";
        }
        diagnostics.add(each);
    }
    if (!finite) image.reset();
    return image;
}

struct CompareCommand {
    std::string reference, test, metric = "flip", output, exposure_output, tone, exposures,
                                 diagnostics = "text";
    double ppd = report::default_pixels_per_degree;
    std::optional<double> scale;
    CompareLimits limits;
    bool json = false;

    int run() {
        if (const std::string why = wrong_usage(); !why.empty()) return fail(exit_usage, why);
        Diagnostics problems;
        auto a = load_finite(reference, problems);
        auto b = load_finite(test, problems);
        if (a && b) find_mismatch(*a, *b, problems);
        if (const int code = report(problems, diagnostics); code != exit_success) return code;
        const bool hdr = !is_integer(a->source) || !is_integer(b->source);
        if (!hdr && !(tone.empty() && exposures.empty() && exposure_output.empty()))
            return fail(exit_usage,
                        "--tone, --exposures and --exposure-map go with images of floats");
        const Comparison comparison = compared(std::move(*a), std::move(*b), hdr);
        Diagnostics environment;
        if (!write_maps(comparison, environment)) {
            report(environment, diagnostics);
            return exit_environment;
        }
        const report::Pooling pooled(comparison.map);
        const auto print = json ? as_json : as_text;
        if (write_result("-", print(comparison, pooled, limits)) != exit_success)
            return exit_environment;
        return exceeded(comparison, pooled, limits).empty() ? exit_success : exit_input;
    }

    std::string wrong_usage() {
        if (reference == "-" || test == "-" || output == "-" || exposure_output == "-")
            return "compare reads and writes files, not streams";
        std::vector<std::string> made;
        for (const std::string& file : {output, exposure_output})
            if (!file.empty()) made.push_back(file);
        for (const std::string& file : made)
            if (!is_map_name(file)) return file + ": expected .png, .jpg, .tif or .exr";
        if (const std::string why = overwrite_fault_of_run(made, {reference, test}); !why.empty())
            return why;
        if (!(ppd >= report::min_pixels_per_degree && ppd <= report::max_pixels_per_degree))
            return "--ppd: expected 1 to 1000 pixels per degree";
        if (metric != "flip" && !(tone.empty() && exposures.empty() && exposure_output.empty()))
            return "--tone, --exposures and --exposure-map go with --metric flip";
        if (scale && !(*scale > 0 && std::isfinite(*scale)))
            return "--scale: expected a number above 0";
        for (const auto& limit : {limits.mean, limits.pixel, limits.over})
            if (limit && !(*limit >= 0 && std::isfinite(*limit)))
                return "--max-mean, --max-pixel and --over: expected a number, 0 or above";
        if (!exposures.empty() && !parse_exposures())
            return "--exposures " + exposures +
                   ": expected START,STOP,COUNT such as -3,2,4, in -100 to 100 EV, at most 32";
        return {};
    }

    std::optional<report::Exposures> parse_exposures() const {
        double numbers[3];
        if (!parse_numbers<double>(exposures, ',', numbers)) return {};
        const auto [start, stop, count] = numbers;
        if (!(std::abs(start) <= 100) || !(std::abs(stop) <= 100)) return {};
        if (!(count >= 1 && count <= report::max_exposures) || count != std::floor(count))
            return {};
        return report::Exposures{start, stop, static_cast<uint32_t>(count)};
    }

    void find_mismatch(const Image& a, const Image& b, Diagnostics& problems) const {
        if (a.width != b.width || a.height != b.height)
            problems.add(file_problem(
                Severity::error, RuleId::image_values, test,
                "has " + size_text(b) + " pixels, " + reference + " has " + size_text(a),
                "two images of one size"));
        if (metric != "degrees") return;
        for (const auto& [file, image] : {std::pair(reference, &a), std::pair(test, &b)})
            if (!report::has_normals(*image))
                problems.add(file_problem(Severity::error, RuleId::image_values, file,
                                          "is a gray image",
                                          "a normal map, or --metric flip or rms"));
    }

    Comparison compared(Image a, Image b, bool hdr) const {
        Comparison result;
        result.metric = metric;
        result.map_file = output;
        result.exposure_file = exposure_output;
        if (metric == "flip") {
            result.pixels_per_degree = ppd;
            if (hdr)
                compare_hdr(std::move(a), std::move(b), result);
            else
                result.map = map_of(metric, std::move(a), std::move(b), ppd);
        } else {
            result.map = map_of(metric, std::move(a), std::move(b));
            result.scale = *std::ranges::max_element(result.map.data);
            if (result.scale == 0) result.scale = 1;
        }
        result.scale = scale.value_or(result.scale);
        return result;
    }

    void compare_hdr(Image a, Image b, Comparison& result) const {
        decode_loaded(a);
        decode_loaded(b);
        result.tone = tone.empty() ? report::tone_names[0] : tone;
        const report::Tone curve = *report::tone_named(result.tone);
        result.exposures = exposures.empty() ? report::exposures_of(a, curve) : *parse_exposures();
        auto [errors, exposure_map] = report::hdr_flip(a, b, curve, result.exposures, ppd);
        result.map = std::move(errors);
        result.exposure_map = std::move(exposure_map);
    }

    static bool write_map(const std::string& file, const Image& map, const report::Colormap& colors,
                          double scale, Diagnostics& environment) {
        if (file.empty()) return true;
        WriterOptions options;
        const bool values = fs::path(file).extension() == ".exr";
        options.type = values ? PixelType::float32 : PixelType::u8;
        return save_image(values ? map : report::colored(map, colors, scale), file, options,
                          environment);
    }

    static bool write_maps(const Comparison& comparison, Diagnostics& environment) {
        return write_map(comparison.map_file, comparison.map, report::magma, comparison.scale,
                         environment) &&
               write_map(comparison.exposure_file, comparison.exposure_map, report::viridis, 1,
                         environment);
    }
};

void declare_limits(CLI::App& sub, CompareLimits& limits) {
    sub.add_option("--max-mean", limits.mean,
                   "Limit of the mean; of rms, of the root mean square over all pixels")
        ->type_name("X");
    sub.add_option("--max-pixel", limits.pixel, "Limit of every pixel")->type_name("X");
    CLI::Option* over =
        sub.add_option("--over", limits.over, "Count the pixels above LIMIT")->type_name("LIMIT");
    sub.add_option("--max-over", limits.max_over, "Limit of that count")
        ->type_name("COUNT")
        ->needs(over);
}

}  // namespace

void declare_compare(CLI::App& app, Run& run) {
    auto [sub, c] =
        add_command<CompareCommand>(app, run, "compare", "How far two images are apart");
    sub.add_option("A", c.reference, "The reference: PNG, JPEG, TIFF, OpenEXR, HDR, PFM, PNM")
        ->required();
    sub.add_option("B", c.test, "An image of the same size")->required();
    add_choice(sub, "--metric", c.metric, image_metrics,
               "flip: the visible difference, 0 to 1; degrees: angle of normals in normal maps; "
               "rms: root mean square in steps of 8 bits");
    sub.add_option("-o", c.output,
                   "Map of the difference: .png, .jpg or .tif in the colors of magma, .exr with "
                   "the values")
        ->type_name("OUT");
    sub.add_option("--scale", c.scale,
                   "Value with the last color of the map; default: 1 for flip, else the largest")
        ->type_name("X");
    sub.add_option("--ppd", c.ppd, "Pixels per degree that the observer of flip sees")
        ->type_name("N")
        ->capture_default_str();
    declare_limits(sub, c.limits);
    add_choice(sub, "--tone", c.tone, report::tone_names,
               "Tone mapper of flip for images of floats; default: aces");
    sub.add_option("--exposures", c.exposures,
                   "Exposures of flip for images of floats, in EV; default: from A")
        ->type_name("START,STOP,COUNT");
    sub.add_option("--exposure-map", c.exposure_output,
                   "Map of the exposure with the largest difference, in the colors of viridis")
        ->type_name("OUT");
    sub.add_flag("--json", c.json, "Numbers for programs");
    declare_diagnostics(sub, c.diagnostics);
}

}  // namespace wrinkle::cli
