// Detection of outputs that would overwrite other files of the same run.
#pragma once

#include <span>
#include <string>

namespace wrinkle {

// Returns a sentence that names both files if an output is an input of the same run, or another
// output; "" if all may be written. Compares files, not names: different spellings, symbolic links
// and hard links of one file are equal. "-", devices and pipes are ignored. O(n log n) with one
// stat call per file.
std::string overwrite_fault(std::span<const std::string> outputs,
                            std::span<const std::string> inputs);

}  // namespace wrinkle
