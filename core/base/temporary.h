// Temporary files that replace their target by one rename (atomic write).
//
// ".wrinkle-tmp-PID-N.EXT" is in the folder of the target and is locked (flock) as long as its
// writer runs. A file with such a name and no lock is left over from a killed program; the next
// Temporary in that folder removes it. Each folder is searched once per process. File names are at
// most 48 bytes long.
#pragma once

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

namespace wrinkle {

// Returns the error code of the last failed system call (errno).
inline std::error_code last_error() {
    return {errno, std::generic_category()};
}

class Temporary {
public:
    // Creates an empty file in the folder of `target`, with its extension if that has at most 8
    // bytes. Returns std::nullopt and sets `error` on failure.
    static std::optional<Temporary> beside(const std::filesystem::path& target,
                                           std::error_code& error);
    Temporary(Temporary&& other) noexcept;
    Temporary& operator=(Temporary&&) = delete;
    ~Temporary() { remove(); }

    // Returns true if a file name (without folder) is that of a temporary file of any process.
    static bool is_name(std::string_view file) { return file.starts_with(prefix); }

    const std::filesystem::path& path() const { return path_; }
    // Appends the bytes.
    std::error_code write(std::string_view bytes) const;
    std::error_code sync() const;  // fsync

    // Renames the file to `target`. If `target` exists, its permissions are copied first. Removes
    // the temporary file on failure.
    std::error_code place(const std::filesystem::path& target);
    void remove();  // no effect after place()

private:
    Temporary(std::filesystem::path path, int handle) : path_(std::move(path)), handle_(handle) {}

    static constexpr std::string_view prefix = ".wrinkle-tmp-";

    std::filesystem::path path_;
    int handle_ = -1;  // -1: removed or renamed
};

}  // namespace wrinkle
