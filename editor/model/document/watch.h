// Detects that another program wrote the open file: checks its date each second, and its bytes only
// if the date differs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace wrinkle::editor {

// FNV-1a hash of a text, to recognize it.
uint64_t checksum(std::string_view bytes);

struct Stamp {
    bool there = false;
    int64_t seconds = 0, nanoseconds = 0;  // last modification
    uint64_t size = 0, inode = 0;
    bool operator==(const Stamp&) const = default;
};
Stamp stamp_of(const std::filesystem::path& file);

double seconds_now();  // monotonic clock, seconds; for times of checks

// The file at the last read or write.
struct DiskCopy {
    Stamp stamp;
    uint64_t bytes = 0;  // checksum

    static DiskCopy of(const std::filesystem::path& file, std::string_view bytes);
};

enum class OnDisk : uint8_t { same, changed, gone };
// Compares with the current file; updates `known` if only the date differs.
OnDisk compare(DiskCopy& known, const std::filesystem::path& file);

}  // namespace wrinkle::editor
