// Detects that another program changed a file: compares its stamp, and its bytes only if the stamp
// differs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

namespace wrinkle {

struct Stamp {
    bool there = false;
    int64_t seconds = 0, nanoseconds = 0;  // last modification
    uint64_t size = 0, inode = 0;
    bool operator==(const Stamp&) const = default;
};
// Follows links. A file that does not exist or cannot be examined has Stamp{}.
Stamp stamp_of(const std::filesystem::path& file);

// A fingerprint of the file at the last read or write.
struct DiskCopy {
    Stamp stamp;
    uint64_t bytes = 0;  // XXH64

    // Takes the bytes that were just written to the file.
    static DiskCopy of(const std::filesystem::path& file, std::string_view bytes);
    // Takes bytes that were read after the stamp was taken, so that a change during the read gives
    // another stamp.
    static DiskCopy of(const Stamp& stamp, std::string_view bytes);
    // Reads the file. The contents of a folder are the names in it, except temporary ones.
    static DiskCopy of(const std::filesystem::path& file);
};

enum class OnDisk : uint8_t { same, changed, gone };
// Compares with the current file or folder; updates `known` if the stamp differs and the
// contents are equal.
OnDisk compare(DiskCopy& known, const std::filesystem::path& file);

}  // namespace wrinkle
