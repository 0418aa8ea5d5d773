// Detects the class of a bump image and its defects, with the numbers behind each result.
// docs/maps.md#wrinkle-lint defines the classes (MapClass), the curl test and the findings
// (MapDefect); maps/lint.cpp has the thresholds.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "base/texture_options.h"
#include "image/image.h"
#include "image/load.h"
#include "maps/map.h"

namespace wrinkle::maps {

enum class MapClass : uint8_t {
    height,
    normal_gl,
    normal_dx,
    normal,
    normal_object,
    two_channel,
    color
};
std::string_view name_of(MapClass map_class);
std::string_view description_of(MapClass map_class);

struct Measure {
    std::string name;  // "curl_gl"
    double value = 0;
};

// `unexpected` is added only by callers that know the expected class.
enum class MapDefect : uint8_t {
    tilt,
    unsigned_z,
    length,
    offset,
    banding,
    mixed,
    seam_u,
    seam_v,
    gray,
    one_value,
    not_finite,
    unexpected
};
std::string_view name_of(MapDefect defect);   // "seam_u"
std::string_view words_of(MapDefect defect);  // description without numbers, half a sentence

struct Finding {
    MapDefect defect = MapDefect::unexpected;
    std::string message;  // one sentence with its numbers
    bool is_defect = true;
};

struct Verdict {
    MapClass map_class = MapClass::color;
    std::vector<Measure> evidence;
    std::vector<Finding> findings;

    bool has_defects() const;
    std::optional<double> measure(std::string_view name) const;
};

// `wrap`: Wrap::repeat if the image must tile.
Verdict examine(const Image& image, Wrap wrap);

// Reads a few rows of the file at a time. `stopped` is called before each row; if it returns true,
// the result is std::nullopt without an error. Otherwise std::nullopt means failure, with
// diagnostics.
struct ExaminedFile {
    ImageInfo info;
    Verdict verdict;
};
std::optional<ExaminedFile> examine(const std::filesystem::path& file, Wrap wrap,
                                    Diagnostics& diagnostics,
                                    const std::function<bool()>& stopped = {});

}  // namespace wrinkle::maps
