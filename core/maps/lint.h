// What a picture of a bump is, and what is wrong with it, each with the numbers that say so.
//
// What it is:
//   height         one channel, or three that are equal
//   normal_gl, normal_dx   of tangent space: the vectors 2t - 1 have length 1 and point up. Which
//                  way green is says the curl test: the slopes of a height have no curl, so where
//                  d/dv of the one and d/du of the other go together, green points up
//   normal         the same, with slopes that do not tell (flat, or ridges along one axis)
//   normal_object  unit vectors that also point down
//   two_channel    red and green about the middle, blue missing or one value that does not make the
//                  vectors unit and up: slopes, or normals whose z is made
//   color          none of them
//
// What is wrong (`defect`), or only worth knowing:
//   tilt       the mean normal leans: a bump that repeats has none
//   unsigned_z blue holds z from 0 to 1, not (1 + z) / 2
//   length     the vectors are neither unit as 2t - 1 nor with an unsigned z
//   offset     8 bits, and what is not flat lies half a step beside the middle: 127 or 128 was
//              taken for 127.5
//   banding    steps of one level with plateaus between them, or 8 bits in a deeper file
//   mixed      green points up in some regions and down in others, so the whole is `normal`
//   seam_u, seam_v   the first and last columns or rows differ more than any neighbours inside.
//              A defect only where the image is to repeat and is not an atlas: islands on a
//              background that is flat or empty, or a file that `wrinkle bake` wrote
//   gray       a height with three channels
//   one_value  a height that is the same everywhere, which makes no bump
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

enum class Look : uint8_t {
    height,
    normal_gl,
    normal_dx,
    normal,
    normal_object,
    two_channel,
    color
};
std::string_view name_of(Look look);
std::string_view description_of(Look look);

struct Measure {
    std::string name;  // "curl_gl"
    double value = 0;
};

// As above; and `unexpected`, which whoever knows what the picture was to be adds.
enum class Flaw : uint8_t {
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
std::string_view name_of(Flaw flaw);   // "seam_u"
std::string_view words_of(Flaw flaw);  // what is wrong, half a sentence without its numbers

struct Finding {
    Flaw flaw = Flaw::unexpected;
    std::string message;  // one sentence with its numbers
    bool defect = true;
};

struct Verdict {
    Look look = Look::color;
    std::vector<Measure> evidence;
    std::vector<Finding> findings;

    bool has_defects() const;
    std::optional<double> measure(std::string_view name) const;
};

// `wrap` says whether the picture is to repeat.
Verdict examine(const Image& image, Wrap wrap);

// Of a file, in memory for a few of its rows; nothing with errors. `stopped` is asked between a row
// and the next: where it says true there is no verdict, and no error.
struct ExaminedFile {
    ImageInfo info;
    Verdict verdict;
};
std::optional<ExaminedFile> examine(const std::filesystem::path& file, Wrap wrap,
                                    Diagnostics& diagnostics,
                                    const std::function<bool()>& stopped = {});

}  // namespace wrinkle::maps
