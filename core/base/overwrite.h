// What the outputs of one run would replace.
#pragma once

#include <span>
#include <string>

namespace wrinkle {

// A sentence that names the two where an output is an input of the same run, or another output; ""
// when all may be written. Files are compared, not names: another spelling, a link and a hard link
// lead to the same file. "-", devices and pipes are nothing that a run could replace.
// O(n log n), one look at the disk a file.
std::string overwrite_fault(std::span<const std::string> outputs,
                            std::span<const std::string> inputs);

}  // namespace wrinkle
