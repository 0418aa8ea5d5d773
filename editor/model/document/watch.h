// Detects that another program wrote the open file: base/disk_copy.h, checked each second.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/disk_copy.h"

namespace wrinkle::editor {

// FNV-1a hash of a text, to recognize it.
uint64_t checksum(std::string_view bytes);

double seconds_now();  // monotonic clock, seconds; for times of checks

}  // namespace wrinkle::editor
