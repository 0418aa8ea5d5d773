// Whether another program wrote the open file: a look at its date each second, and a look at its
// bytes only when the date is another.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace wrinkle::editor {

// Of a text, to know it again; FNV-1a.
uint64_t checksum(std::string_view bytes);

struct Stamp {
    bool there = false;
    int64_t seconds = 0, nanoseconds = 0;  // of the last change
    uint64_t size = 0, inode = 0;
    bool operator==(const Stamp&) const = default;
};
Stamp stamp_of(const std::filesystem::path& file);

double seconds_now();  // of a clock that nobody sets: when something was looked at last

// The file as it was read or written last.
struct DiskCopy {
    Stamp stamp;
    uint64_t bytes = 0;  // checksum

    static DiskCopy of(const std::filesystem::path& file, std::string_view bytes);
};

enum class OnDisk : uint8_t { same, changed, gone };
// Against the file as it is now; a copy whose date alone is old is brought up to date.
OnDisk compare(DiskCopy& known, const std::filesystem::path& file);

}  // namespace wrinkle::editor
