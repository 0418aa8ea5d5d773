#include "base/disk_copy.h"

#include <sys/stat.h>

#include <optional>
#include <set>
#include <string>

#include "base/checksum.h"
#include "base/file.h"
#include "base/temporary.h"
#include "base/text.h"

namespace wrinkle {
namespace fs = std::filesystem;
namespace {

std::optional<std::string> contents_of(const fs::path& file) {
    std::error_code error;
    std::string why;
    if (!fs::is_directory(file, error)) return read_file(file, why);
    std::set<std::string> names;
    for (fs::directory_iterator at(file, error), end; !error && at != end; at.increment(error))
        if (const std::string name = at->path().filename(); !Temporary::is_name(name))
            names.insert(name);
    return joined(names, "/");
}

}  // namespace

Stamp stamp_of(const fs::path& file) {
    struct stat found = {};
    if (file.empty() || stat(file.c_str(), &found) != 0) return {};
    return {true, found.st_mtim.tv_sec, found.st_mtim.tv_nsec, static_cast<uint64_t>(found.st_size),
            found.st_ino};
}

DiskCopy DiskCopy::of(const fs::path& file, std::string_view bytes) {
    return of(stamp_of(file), bytes);
}

DiskCopy DiskCopy::of(const Stamp& stamp, std::string_view bytes) {
    return {stamp, xxh64(bytes)};
}

DiskCopy DiskCopy::of(const fs::path& file) {
    const Stamp stamp = stamp_of(file);  // before reading: a later change gives another
    const auto bytes = stamp.there ? contents_of(file) : std::nullopt;
    return {stamp, bytes ? xxh64(*bytes) : 0};
}

OnDisk compare(DiskCopy& known, const fs::path& file) {
    const Stamp now = stamp_of(file);
    if (now == known.stamp) return OnDisk::same;
    if (!now.there) return OnDisk::gone;
    const auto bytes = contents_of(file);
    if (!bytes || !known.stamp.there || xxh64(*bytes) != known.bytes) return OnDisk::changed;
    known.stamp = now;
    return OnDisk::same;
}

}  // namespace wrinkle
