#include "editor/drop/image_kind.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "editor/panels/search.h"
#include "image/load.h"

namespace wrinkle::editor {
namespace {

constexpr size_t sample_size = 65536;
constexpr uint64_t most_pixels = uint64_t{64} << 20;

// Shares of the pixels, 0 to 1.
struct Statistics {
    double grey = 0, unit = 0, up = 0;
    float least_blue = 1, most_blue = 0;
};

Statistics measure(const Image& image) {
    Statistics result;
    const size_t pixels = static_cast<size_t>(image.width) * image.height;
    const size_t step = std::max<size_t>(pixels / sample_size, 1);
    size_t count = 0, grey = 0, unit = 0, up = 0;
    for (size_t i = 0; i < pixels; i += step, ++count) {
        const auto c =
            expand_texel(image.data.data() + i * image.channels, image.channels, image.has_alpha);
        constexpr float equal = 2.0F / 255;
        grey += std::fabs(c[0] - c[1]) <= equal && std::fabs(c[1] - c[2]) <= equal;
        const float x = 2 * c[0] - 1, y = 2 * c[1] - 1, z = 2 * c[2] - 1;
        unit += std::fabs(std::sqrt(x * x + y * y + z * z) - 1) <= 0.1F;
        up += z > 0;
        result.least_blue = std::min(result.least_blue, c[2]);
        result.most_blue = std::max(result.most_blue, c[2]);
    }
    const auto share = [&](size_t n) {
        return static_cast<double>(n) / std::max<size_t>(count, 1);
    };
    result.grey = share(grey);
    result.unit = share(unit);
    result.up = share(up);
    return result;
}

std::string percent(double share) {
    return std::to_string(static_cast<int>(share * 100)) + " %";
}

bool says(std::string_view name, std::initializer_list<std::string_view> words) {
    const std::string lower = lower_case(name);
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view word) { return lower.find(word) != lower.npos; });
}

ImageKind by_name(std::string_view name) {
    const std::string why = "its name says so";
    if (says(name, {"normal", "_nrm", "_nor."})) return {"tangent_normal_map", why};
    if (says(name, {"height", "bump", "disp", "depth"})) return {"height_map", why};
    if (says(name, {"slope", "derivative"})) return {"derivative_map", why};
    return {"image", "nothing says that it is a bump"};
}

}  // namespace

ImageKind kind_of(const Image& image, std::string_view name) {
    const bool pair = image.channels == 2 && !image.has_alpha;
    if (pair) return {"derivative_map", "it has two channels"};
    if (image.channels < 3) return {"height_map", "it has one channel"};
    const Statistics s = measure(image);
    if (s.grey >= 0.99) return {"height_map", percent(s.grey) + " of its pixels are grey"};
    // A constant blue that would point up is a normal map of a flat surface.
    if (s.most_blue - s.least_blue < 2.0F / 255 && s.most_blue < 0.75F)
        return {"derivative_map", "its blue is constant"};
    if (s.unit >= 0.9 && s.up >= 0.99)
        return {"tangent_normal_map",
                percent(s.unit) + " of its pixels are unit vectors that point up"};
    if (s.unit >= 0.9) {
        const std::string why = percent(s.unit) + " of its pixels are unit vectors to all sides";
        return {image.width == 6 * image.height ? "cube_normal_map" : "object_normal_map", why};
    }
    return by_name(name);
}

std::optional<ImageKind> kind_of_file(const std::filesystem::path& file, std::string& problem) {
    Diagnostics problems;
    const std::string name = file.filename().string();
    const ImageLimits limits = image_limits_from_environment(problems);
    const auto info = read_image_info(file, limits, problems);
    if (info && uint64_t{info->width} * info->height > most_pixels) return by_name(name);
    const auto image = info ? load_image(file, limits, problems) : std::nullopt;
    if (image) return kind_of(*image, name);
    problem = name + " cannot be used";
    for (const Diagnostic& each : problems.list())
        if (each.severity == Severity::error) problem = each.message;
    return std::nullopt;
}

}  // namespace wrinkle::editor
