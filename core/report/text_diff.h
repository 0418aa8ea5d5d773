// Differences of two texts by lines.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::report {

struct DiffLine {
    enum class Kind : uint8_t { common, removed, added, skipped };
    Kind kind = Kind::common;
    uint32_t expected_line = 0, actual_line = 0;  // from 1; 0: not in that text
    std::string_view text;                        // part of its text; skipped: ""
};

// Returns a shortest list of removed and added lines, with `context` common lines around each; each
// run of other lines is one line of Kind::skipped. If the product of the line counts between the
// first and the last difference is above 4,000,000, all these lines are removed and added. The
// lines refer to the texts. O(n + d^2) time and memory for n lines, d of which are between the
// first and the last difference.
std::vector<DiffLine> diff_lines(std::string_view expected, std::string_view actual,
                                 uint32_t context = 3);

}  // namespace wrinkle::report
