// Files, read whole and written whole or not at all.
//
// One rule holds for every file that is read: it is a regular file, links followed, of at most so
// many bytes, which are counted while it is read. A folder, pipe, device or socket is refused at
// once, without waiting for a writer. What a file names goes through inside() first. Streams are
// read where the user names one, and nowhere else.
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

// A regular file to read from, or null with the reason in `why` ("cannot be read: No such ...",
// "is a pipe, not a file").
OpenedFile open_to_read(const std::filesystem::path& path, std::string& why);

// The whole file of at most `max_bytes` (default: Limit::file_bytes), or nothing with the reason in
// `why`.
std::optional<std::string> read_file(const std::filesystem::path& path, std::string& why);
std::optional<std::string> read_file(const std::filesystem::path& path, uint64_t max_bytes,
                                     std::string& why);

// What a stream is called in messages: "<stdin>" for "-", "/dev/stdin" and the like, "<fd 63>" for
// "/dev/fd/63", as `<(COMMAND)` of a shell is spelled; "" for all else.
std::string stream_title(std::string_view name);
// The whole of such a stream, up to Limit::file_bytes.
std::optional<std::string> read_stream(std::string_view name, std::string& why);

// Writes to a Temporary beside `path` and renames it. A file that already holds these bytes
// is left untouched, so build systems see no change; one that is replaced keeps its permissions. A
// symbolic link stays: the file it leads to is replaced. What is no regular file (a device, a pipe)
// is opened and written to. False with the reason in `why`.
bool write_file(const std::filesystem::path& path, std::string_view bytes, std::string& why);

// The same for work that nobody can make again: the bytes are on the disk before they take the
// place of the old ones, and the new name is before it returns. The system's error, or none.
std::error_code write_file_synced(const std::filesystem::path& path, std::string_view bytes);

// The same for several files: none is replaced before all have been written under their temporary
// names, and they are replaced in this order, so that a killed program leaves the last one old as
// long as any is. `why` then names the file too.
struct FileBytes {
    std::filesystem::path path;
    std::string_view bytes;
};
bool write_files(std::span<const FileBytes> files, std::string& why);

// Puts a file that was written beside it in the place of `path`, as write_file() does.
bool replace_file(Temporary& written, const std::filesystem::path& path, std::string& why);

// Where writing to `path` ends: symbolic links are followed, the last may lead nowhere yet.
std::filesystem::path link_target(const std::filesystem::path& path);

// `path` made absolute with symbolic links resolved as far as it exists. Without an error to tell
// of, "" is the working folder, and what cannot be resolved stays as it is.
std::filesystem::path real_path(const std::filesystem::path& path, std::error_code& error);
std::filesystem::path real_path(const std::filesystem::path& path);

// `path` made absolute with symbolic links resolved as far as it exists, if that place is `root`
// or below it; nothing if it climbs out.
std::optional<std::filesystem::path> inside(const std::filesystem::path& root,
                                            const std::filesystem::path& path);
// The same of what `folder` names, where real_path() gave both the root and the folder.
std::optional<std::filesystem::path> inside_real(const std::filesystem::path& real_root,
                                                 std::string_view folder, std::string_view name);

}  // namespace wrinkle
