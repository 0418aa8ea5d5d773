#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/file.h"
#include "base/file_log.h"
#include "base/limits.h"
#include "base/text.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

std::string unread() {
    return "cannot be read: " + std::string(std::strerror(errno));
}

const char* kind_of(mode_t mode) {
    return S_ISDIR(mode)    ? "folder"
           : S_ISFIFO(mode) ? "pipe"
           : S_ISSOCK(mode) ? "socket"
                            : "device";
}

std::string too_large(uint64_t max_bytes) {
    return "is larger than " + std::to_string(max_bytes) + " bytes; " +
           std::string(row_of(Limit::file_bytes).variable) + " sets another limit";
}

// Counts bytes while reading too: a file may grow, and a stream has no size.
std::optional<std::string> read_all(std::FILE* file, uint64_t max_bytes, std::string& why) {
    struct stat found {};
    const bool regular = fstat(fileno(file), &found) == 0 && S_ISREG(found.st_mode);
    const uint64_t size = regular ? static_cast<uint64_t>(found.st_size) : 0;
    if (size > max_bytes) {
        why = too_large(max_bytes);
        return {};
    }
    std::string bytes;
    bytes.reserve(size);
    char buffer[1 << 16];
    size_t count = 0;
    while ((count = std::fread(buffer, 1, sizeof buffer, file)) > 0) {
        if (bytes.size() + count > max_bytes) {
            why = too_large(max_bytes);
            return {};
        }
        bytes.append(buffer, count);
    }
    if (!std::ferror(file)) return bytes;
    why = unread();
    return {};
}

// Returns the file descriptor that the name refers to; std::nullopt if the name is a path.
std::optional<int> stream_number(std::string_view name) {
    if (name == "-" || name == "/dev/stdin") return 0;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!name.starts_with(folder)) continue;
        const auto number = whole_number(name.substr(folder.size()));
        if (number && *number <= 1'000'000) return static_cast<int>(*number);
    }
    return {};
}

}  // namespace

// O_NONBLOCK avoids waiting in open() for pipes; it does not affect regular files.
OpenedFile open_to_read(const fs::path& path, std::string& why) {
    log_input(path);
    const int handle = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (handle < 0) {
        why = errno == ENXIO ? "is a socket, not a file" : unread();
        return {};
    }
    struct stat found {};
    const bool regular = fstat(handle, &found) == 0 && S_ISREG(found.st_mode);
    OpenedFile file(regular ? fdopen(handle, "rb") : nullptr);
    if (file) return file;
    why = regular ? unread() : "is a " + std::string(kind_of(found.st_mode)) + ", not a file";
    close(handle);
    errno = EINVAL;  // for callers that read the system error
    return {};
}

std::optional<std::string> read_file(const fs::path& path, std::string& why) {
    return read_file(path, limit_of(Limit::file_bytes), why);
}

std::optional<std::string> read_file(const fs::path& path, uint64_t max_bytes, std::string& why) {
    const OpenedFile file = open_to_read(path, why);
    if (!file) return {};
    return read_all(file.get(), max_bytes, why);
}

std::string stream_title(std::string_view name) {
    const auto number = stream_number(name);
    if (!number) return {};
    return *number == 0 ? "<stdin>" : "<fd " + std::to_string(*number) + ">";
}

std::optional<std::string> read_stream(std::string_view name, std::string& why) {
    const int handle = fcntl(stream_number(name).value_or(-1), F_DUPFD_CLOEXEC, 0);
    const OpenedFile file(handle < 0 ? nullptr : fdopen(handle, "rb"));
    if (file) return read_all(file.get(), limit_of(Limit::file_bytes), why);
    why = unread();
    if (handle >= 0) close(handle);
    return {};
}

}  // namespace wrinkle
