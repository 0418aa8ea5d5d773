// Files, read whole and written whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace wrinkle {

// The whole file, or nothing with the reason in `why` ("cannot be read: No such file or ...").
std::optional<std::string> read_file(const std::filesystem::path& path, std::string& why);

// Writes to a temporary name beside `path` and renames it. A file that already holds these bytes
// is left untouched, so build systems see no change. False with the reason in `why`.
bool write_file(const std::filesystem::path& path, std::string_view bytes, std::string& why);

// `path` made absolute with symbolic links resolved as far as it exists, if that place is `root`
// or below it; nothing if it climbs out.
std::optional<std::filesystem::path> inside(const std::filesystem::path& root,
                                            const std::filesystem::path& path);

}  // namespace wrinkle
