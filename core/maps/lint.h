// Detects the class of a bump image and its defects, with the numbers behind each result.
//
// Classes (MapClass); t is the stored value of a texel, 0 to 1:
//   height         one channel, or three equal ones
//   normal_gl, normal_dx   tangent space: the vectors 2t - 1 have length 1 and point up. The curl
//                  test decides the direction of green: the slopes of a height have no curl, so if
//                  d/dv of one slope and d/du of the other correlate, green points up
//   normal         the same, with slopes that do not decide (flat, or ridges along one axis)
//   normal_object  unit vectors of which some point down
//   two_channel    the means of red and green are near 0.5; blue is missing, or constant and does
//                  not give unit vectors that point up. Slopes, or normals with reconstructed z
//   color          none of these
//
// Findings (MapDefect), as defects or as information:
//   tilt       the mean normal is tilted; the mean normal of a repeating bump points up
//   unsigned_z blue holds z from 0 to 1, not (1 + z) / 2
//   length     the vectors are unit neither as 2t - 1 nor with an unsigned z
//   offset     8 bits, and texels that are not flat are offset by half a step: 127 or 128 was used
//              instead of 127.5
//   banding    steps of one level between plateaus, or 8-bit values in a deeper file
//   mixed      green points up in some regions and down in others; the class is then `normal`
//   seam_u, seam_v   the first and last columns or rows differ more than twice as much as 99 % of
//              the neighbours inside. A defect only if the image must repeat and is not an
//              atlas: islands on a flat or empty background, or a file by `wrinkle bake`
//   gray       a height with three channels
//   one_value  a constant height, which makes no bump
//   not_finite NaN or infinity
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

// Findings as listed above. `unexpected` is added only by callers that know the expected class.
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
