#include "base/file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

std::string reason() {
    return std::strerror(errno);
}

bool write_all(const fs::path& path, std::string_view bytes) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) return false;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    return std::fclose(file) == 0 && written;
}

}  // namespace

std::optional<std::string> read_file(const fs::path& path, std::string& why) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
        why = "is a folder, not a file";
        return {};
    }
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (!file) {
        why = "cannot be read: " + reason();
        return {};
    }
    std::string bytes;
    char buffer[1 << 16];
    size_t count = 0;
    while ((count = std::fread(buffer, 1, sizeof buffer, file)) > 0)
        bytes.append(buffer, count);
    const bool failed = std::ferror(file) != 0;
    std::fclose(file);
    if (failed) {
        why = "cannot be read: " + reason();
        return {};
    }
    return bytes;
}

bool write_file(const fs::path& path, std::string_view bytes, std::string& why) {
    std::string ignored;
    if (const auto old = read_file(path, ignored); old && *old == bytes) return true;
    fs::path temporary = path;
    temporary += ".tmp" + std::to_string(getpid());
    std::error_code error;
    if (!write_all(temporary, bytes)) {
        why = "cannot be written: " + reason();
        fs::remove(temporary, error);
        return false;
    }
    fs::rename(temporary, path, error);
    if (error) {
        why = "cannot be written: " + error.message();
        fs::remove(temporary, error);
        return false;
    }
    return true;
}

std::optional<fs::path> inside(const fs::path& root, const fs::path& path) {
    std::error_code error;
    const fs::path real_root = fs::weakly_canonical(fs::absolute(root), error);
    if (error) return {};
    const fs::path real = fs::weakly_canonical(fs::absolute(path), error);
    if (error) return {};
    auto part = real.begin();
    for (const fs::path& expected : real_root) {
        if (expected.empty()) continue;  // a trailing slash
        if (part == real.end() || *part != expected) return {};
        ++part;
    }
    return real;
}

}  // namespace wrinkle
