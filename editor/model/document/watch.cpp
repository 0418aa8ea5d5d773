#include "editor/model/document/watch.h"

#include <sys/stat.h>

#include <chrono>

#include "base/file.h"

namespace wrinkle::editor {
namespace fs = std::filesystem;

uint64_t checksum(std::string_view bytes) {
    uint64_t sum = 0xCBF29CE484222325;
    for (const char byte : bytes)
        sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001B3;
    return sum;
}

Stamp stamp_of(const fs::path& file) {
    struct stat found = {};
    if (file.empty() || stat(file.c_str(), &found) != 0) return {};
    return {true, found.st_mtim.tv_sec, found.st_mtim.tv_nsec, static_cast<uint64_t>(found.st_size),
            found.st_ino};
}

double seconds_now() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

DiskCopy DiskCopy::of(const fs::path& file, std::string_view bytes) {
    return {stamp_of(file), checksum(bytes)};
}

OnDisk compare(DiskCopy& known, const fs::path& file) {
    const Stamp now = stamp_of(file);
    if (now == known.stamp) return OnDisk::same;
    if (!now.there) return OnDisk::gone;
    std::string why;
    const auto bytes = read_file(file, why);
    if (!bytes || !known.stamp.there || checksum(*bytes) != known.bytes) return OnDisk::changed;
    known.stamp = now;
    return OnDisk::same;
}

}  // namespace wrinkle::editor
