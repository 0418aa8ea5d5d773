#include "base/temporary.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "base/file_log.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

// An unlocked file belongs to a dead writer, or to one between create and flock; the latter detects
// that its file was unlinked and creates another.
void remove_if_dead(const fs::path& file) {
    const int handle = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (handle < 0) return;
    struct stat found {};
    if (fstat(handle, &found) == 0 && S_ISREG(found.st_mode) &&
        flock(handle, LOCK_EX | LOCK_NB) == 0)
        unlink(file.c_str());
    close(handle);
}

void remove_dead_ones(const fs::path& folder) {
    static std::mutex mutex;
    static std::set<fs::path> searched;
    {
        const std::lock_guard lock(mutex);
        if (!searched.insert(folder).second) return;
    }
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error))
        if (Temporary::is_name(at->path().filename().native())) remove_if_dead(at->path());
}

std::string extension_of(const fs::path& target) {
    constexpr size_t longest = 8;
    std::string extension = target.extension();
    return extension.size() > longest ? std::string() : extension;
}

// Creates the file, locked and still linked; returns -1 and sets errno on failure.
int create(const fs::path& file) {
    for (;;) {
        const int handle = open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (handle < 0) return -1;
        flock(handle, LOCK_EX);  // without lock support, files of dead processes are not removed
        struct stat found {};
        if (fstat(handle, &found) != 0 || found.st_nlink > 0) return handle;
        close(handle);
    }
}

}  // namespace

std::optional<Temporary> Temporary::beside(const fs::path& target, std::error_code& error) {
    static std::atomic<unsigned> count{0};
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    remove_dead_ones(folder);
    const std::string name = std::string(prefix) + std::to_string(getpid()) + "-" +
                             std::to_string(count++) + extension_of(target);
    fs::path file = folder / name;
    int handle = create(file);
    if (handle < 0 && errno == EEXIST) {  // left by a dead process with the same PID
        remove_if_dead(file);
        handle = create(file);
    }
    if (handle < 0) {
        error = last_error();
        return {};
    }
    return Temporary(std::move(file), handle);
}

Temporary::Temporary(Temporary&& other) noexcept
    : path_(std::move(other.path_)), handle_(std::exchange(other.handle_, -1)) {}

void Temporary::remove() {
    if (handle_ < 0) return;
    unlink(path_.c_str());
    close(std::exchange(handle_, -1));
}

std::error_code Temporary::write(std::string_view bytes) const {
    while (!bytes.empty()) {
        const ssize_t count = ::write(handle_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return last_error();
        bytes.remove_prefix(static_cast<size_t>(count));
    }
    return {};
}

std::error_code Temporary::sync() const {
    return fsync(handle_) == 0 ? std::error_code() : last_error();
}

std::error_code Temporary::place(const fs::path& target) {
    struct stat old {};
    if (stat(target.c_str(), &old) == 0 && S_ISREG(old.st_mode))
        fchmod(handle_, old.st_mode & 07777);
    if (rename(path_.c_str(), target.c_str()) != 0) {
        const std::error_code error = last_error();
        remove();
        return error;
    }
    close(std::exchange(handle_, -1));
    log_replaced(target);
    return {};
}

}  // namespace wrinkle
