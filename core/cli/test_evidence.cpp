#include "cli/test_evidence.h"

#include "cli/test_report.h"
#include "image/load.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

// Sets `path`, relative to the report's folder.
bool save_in_report(const Image& image, const fs::path& folder, const fs::path& relative,
                    std::string& path, std::string& why) {
    const fs::path file = folder / relative;
    if (!is_in_report(folder, file)) {
        why = file.string() + ": leads outside the report";
        return false;
    }
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    Diagnostics problems;
    if (!save_image(image, file, {}, problems)) {
        why = problems.list().front().message;
        return false;
    }
    path = relative.generic_string();
    return true;
}

}  // namespace

bool save_images(const CheckImages& images, const fs::path& folder, const std::string& name,
                 report::Check& check, std::string& why) {
    check.width = images.actual.width;
    check.height = images.actual.height;
    check.map_measure = images.compared.map_measure;
    check.map_scale = images.compared.map_scale;
    bool saved = true;
    const auto save = [&](const Image& image, const char* kind, std::string& path) {
        saved = save_in_report(image, folder, fs::path(kind) / (name + ".png"), path, why) && saved;
    };
    save(images.actual, "actual", check.actual_image);
    if (images.expected) save(*images.expected, "expected", check.expected_image);
    if (!images.expected || images.compared.map.empty()) return saved;
    const Image& map = images.compared.map;
    save(map, "map", check.map_image);
    save(side_by_side({images.expected, &images.actual, &map}), "joined", check.joined_image);
    return saved;
}

}  // namespace wrinkle::cli
