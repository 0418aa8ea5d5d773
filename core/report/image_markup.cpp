#include "report/image_markup.h"

#include "base/base64.h"
#include "base/file.h"
#include "report/markup.h"

namespace wrinkle::report {
namespace fs = std::filesystem;
namespace {

// Size of a PNG file: two big-endian numbers after the signature and the head of the chunk IHDR.
bool read_size(const std::string& bytes, InlinedImage& image) {
    constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
    if (bytes.size() < 24 || !bytes.starts_with(signature)) return false;
    const auto number_at = [&](size_t first) {
        uint32_t value = 0;
        for (size_t i = first; i < first + 4; ++i)
            value = value << 8 | static_cast<uint8_t>(bytes[i]);
        return value;
    };
    image.width = number_at(16);
    image.height = number_at(20);
    return image.width > 0 && image.height > 0;
}

InlinedImage inlined(const std::string& name, const fs::path& folder) {
    InlinedImage image;
    std::string why;
    if (name.empty()) return image;
    const auto path = inside(folder, folder / name);
    const auto bytes = path ? read_file(*path, why) : std::nullopt;
    if (bytes && read_size(*bytes, image)) image.uri = "data:image/png;base64," + base64(*bytes);
    return image;
}

// `path` is the image's file, "" if the check has none.
std::string figure(const char* name, const std::string& label, const std::string& path,
                   const InlinedImage& image, const std::string& description) {
    if (path.empty()) return "";
    const std::string open = "<figure class=\"" + std::string(name) + "\">";
    const std::string caption = "<figcaption>" + html(label) + "</figcaption></figure>\n";
    if (image.uri.empty()) return open + "<p>" + html(path) + " is not in this page.</p>" + caption;
    return open + "<div class=\"frame\"><img src=\"" + image.uri + "\" width=\"" +
           std::to_string(image.width) + "\" height=\"" + std::to_string(image.height) +
           "\" alt=\"" + html(description) + "\"></div>" + caption;
}

}  // namespace

InlinedImages inlined_images(const Check& check, const fs::path& folder) {
    return {inlined(check.expected_image, folder), inlined(check.actual_image, folder),
            inlined(check.map_image, folder)};
}

std::string images_markup(const Check& check, const InlinedImages& images) {
    if (check.actual_image.empty() && check.expected_image.empty()) return "";
    const bool is_angle = check.map_measure == "degrees";
    const std::string map = std::string("Difference: ") + (is_angle ? "" : "FLIP, ") + "0 to " +
                            number(check.map_scale) + (is_angle ? " degrees" : "");
    return "<div class=\"images\" data-measure=\"" + html(check.map_measure) + "\" data-scale=\"" +
           number(check.map_scale) + "\">\n" +
           figure("expected", expected_name(check), check.expected_image, images.expected,
                  std::string(expected_name(check)) + ", image of " + check.test) +
           figure("actual", actual_name(check), check.actual_image, images.actual,
                  std::string(actual_name(check)) + ", image of " + check.test) +
           figure("map", map, check.map_image, images.map,
                  "Map of the difference: " + check.message) +
           "</div>\n";
}

}  // namespace wrinkle::report
