// Reading of complete files and atomic writing.
//
// Every file that is read must be a regular file (symbolic links are followed) of at most a given
// number of bytes, which are counted while reading. A folder, pipe, device or socket is rejected
// immediately, without waiting for a writer. Paths named in files are checked by inside() first.
// Streams are read only where the user names one.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "base/temporary.h"

namespace wrinkle {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using OpenedFile = std::unique_ptr<std::FILE, CloseFile>;

// Opens a regular file for reading; returns null and sets `why` on failure ("cannot be read: No
// such ...", "is a pipe, not a file").
OpenedFile open_to_read(const std::filesystem::path& path, std::string& why);

// Returns the contents of a file of at most `max_bytes` (default: Limit::file_bytes); std::nullopt
// with the reason in `why` on failure.
std::optional<std::string> read_file(const std::filesystem::path& path, std::string& why);
std::optional<std::string> read_file(const std::filesystem::path& path, uint64_t max_bytes,
                                     std::string& why);

// Returns the name of a stream for messages: "<stdin>" for "-", "/dev/stdin" and similar, "<fd 63>"
// for "/dev/fd/63", as `<(COMMAND)` of a shell is spelled; "" for any other name.
std::string stream_title(std::string_view name);
// Returns all bytes of such a stream, up to Limit::file_bytes; std::nullopt with the reason in
// `why` on failure.
std::optional<std::string> read_stream(std::string_view name, std::string& why);

// Atomic write: writes to a Temporary in the folder of `path` and renames it. A file that already
// has these contents is left untouched, so build systems see no change; a replaced file keeps its
// permissions. A symbolic link is preserved: its target is replaced. A path that is not a regular
// file (a device, a pipe) is opened and written to. Returns false with the reason in `why` on
// failure.
bool write_file(const std::filesystem::path& path, std::string_view bytes, std::string& why);

// As write_file(), for data that cannot be regenerated: calls fsync on the new file before the
// rename and on the folder after it. Returns the system error, or none.
std::error_code write_file_synced(const std::filesystem::path& path, std::string_view bytes);

// As write_file() for several files: all are written under temporary names, then replaced in this
// order. If the last file is new, all are, even if the process was killed. `why` names the file.
struct FileBytes {
    std::filesystem::path path;
    std::string_view bytes;
};
bool write_files(std::span<const FileBytes> files, std::string& why);

// Moves `written`, a temporary file in the same folder, to `path`, as write_file() does.
bool replace_file(Temporary& written, const std::filesystem::path& path, std::string& why);

// Returns the path that a write to `path` modifies: follows symbolic links; the last may be
// dangling.
std::filesystem::path link_target(const std::filesystem::path& path);

// Returns `path` made absolute, with symbolic links resolved in the part that exists. Without
// `error`, "" is the working folder and a path that cannot be resolved is returned unchanged.
std::filesystem::path real_path(const std::filesystem::path& path, std::error_code& error);
std::filesystem::path real_path(const std::filesystem::path& path);

// Returns `path` made absolute, with symbolic links resolved in the part that exists, if the result
// is `root` or below it; otherwise std::nullopt.
std::optional<std::filesystem::path> inside(const std::filesystem::path& root,
                                            const std::filesystem::path& path);

// Returns the normal form of `path`, relative to `folder` if it is below it. Both are absolute.
// Links are not followed.
std::filesystem::path path_from(const std::filesystem::path& folder,
                                const std::filesystem::path& path);

// Returns a sentence that names both files if an output is an input of the same run, or another
// output; "" if all may be written. Compares files, not names: different spellings, symbolic links
// and hard links of one file are equal. "-", devices and pipes are ignored. O(n log n) with one
// stat call per file.
std::string overwrite_fault(std::span<const std::string> outputs,
                            std::span<const std::string> inputs);

}  // namespace wrinkle
