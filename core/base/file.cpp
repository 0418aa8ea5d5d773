#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>
#include <vector>

#include "base/file_log.h"

namespace wrinkle {
namespace fs = std::filesystem;

namespace {

std::string sentence(const std::error_code& error) {
    const bool folder = error == std::errc::is_a_directory;
    const bool unread = error == std::errc::no_such_device_or_address;
    return "cannot be written: " + (folder   ? std::string("it is a folder")
                                    : unread ? "it is a pipe that no program reads"
                                             : error.message());
}

enum class Sync : bool { no, yes };

// Opens a device or pipe for writing; waits up to 1 s for a reader to open the pipe.
std::FILE* open_special(const fs::path& path) {
    int handle = -1;
    for (int i = 0; i < 100; ++i) {
        handle = open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        if (handle >= 0 || errno != ENXIO) break;
        usleep(10'000);
    }
    if (handle < 0) return nullptr;
    fcntl(handle, F_SETFL, fcntl(handle, F_GETFL) & ~O_NONBLOCK);
    return fdopen(handle, "wb");
}

// Writes the bytes that produce(write) passes to `write`.
template <typename Produce>
std::error_code write_special(const fs::path& path, Produce produce) {
    std::FILE* file = open_special(path);
    if (!file) return last_error();
    std::error_code error = produce([&](std::string_view bytes) {
        const size_t count = std::fwrite(bytes.data(), 1, bytes.size(), file);
        return count == bytes.size() ? std::error_code() : last_error();
    });
    if (std::fclose(file) != 0 && !error) error = last_error();
    return error;
}

// Syncs the entries of a folder. Errors are ignored: some file systems cannot do it and need not.
void sync_folder(const fs::path& folder) {
    const int handle = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
    if (handle < 0) return;
    fsync(handle);
    close(handle);
}

bool is_special(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

bool holds(const fs::path& path, std::string_view bytes) {
    std::string ignored;
    const auto old = read_file(path, bytes.size(), ignored);
    return old && *old == bytes;
}

// Reads in blocks: files may be larger than memory.
template <typename Use>
std::error_code each_block(const fs::path& path, Use use) {
    std::string ignored;
    const OpenedFile file = open_to_read(path, ignored);
    if (!file) return last_error();
    std::vector<char> block(size_t{1} << 20);
    std::error_code error;
    while (!error) {
        const size_t count = std::fread(block.data(), 1, block.size(), file.get());
        if (count == 0) break;
        error = use(std::string_view(block.data(), count));
    }
    if (std::ferror(file.get()) && !error) error = last_error();
    return error;
}

bool hold_the_same(const fs::path& one, const fs::path& other) {
    std::error_code error;
    if (fs::file_size(one, error) != fs::file_size(other, error) || error) return false;
    std::string ignored;
    const OpenedFile file = open_to_read(other, ignored);
    if (!file) return false;
    std::vector<char> block;
    error = each_block(one, [&](std::string_view bytes) {
        block.resize(bytes.size());
        const size_t count = std::fread(block.data(), 1, block.size(), file.get());
        const bool same = count == bytes.size() && bytes == std::string_view(block.data(), count);
        return same ? std::error_code() : make_error_code(std::errc::invalid_argument);
    });
    return !error;
}

// Atomic write of one file: written under a temporary name, then renamed to its target.
class AtomicFileWrite {
public:
    explicit AtomicFileWrite(const FileBytes& file) : file_(file), target_(link_target(file.path)) {
        log_output(file.path);
        log_output(target_);
    }

    std::error_code write(Sync sync = Sync::no) {
        std::error_code error;
        if (fs::is_directory(target_, error)) return make_error_code(std::errc::is_a_directory);
        error.clear();
        if (is_special(target_) || holds(target_, file_.bytes)) return {};
        if (auto made = Temporary::beside(target_, error)) temporary_.emplace(std::move(*made));
        if (!error) error = temporary_->write(file_.bytes);
        return error || sync == Sync::no ? error : temporary_->sync();
    }

    std::error_code place() {
        if (is_special(target_))
            return write_special(target_, [&](auto write) { return write(file_.bytes); });
        return temporary_ ? temporary_->place(target_) : std::error_code();
    }

    const fs::path& target() const { return target_; }

private:
    FileBytes file_;
    fs::path target_;
    std::optional<Temporary> temporary_;  // none: no file to rename
};

}  // namespace

bool write_file(const fs::path& path, std::string_view bytes, std::string& why) {
    AtomicFileWrite file({path, bytes});
    std::error_code error = file.write();
    if (!error) error = file.place();
    if (error) why = sentence(error);
    return !error;
}

std::error_code write_file_synced(const fs::path& path, std::string_view bytes) {
    AtomicFileWrite file({path, bytes});
    if (const std::error_code error = file.write(Sync::yes)) return error;
    const std::error_code error = file.place();
    if (!error) sync_folder(file.target().parent_path());
    return error;
}

bool write_files(std::span<const FileBytes> files, std::string& why) {
    std::vector<AtomicFileWrite> replacements;
    const auto failed = [&](size_t i, const std::error_code& error) {
        if (error) why = files[i].path.string() + ": " + sentence(error);
        return static_cast<bool>(error);
    };
    for (const FileBytes& file : files) {
        replacements.emplace_back(file);
        if (failed(replacements.size() - 1, replacements.back().write())) return false;
    }
    for (size_t i = 0; i < files.size(); ++i)
        if (failed(i, replacements[i].place())) return false;
    return true;
}

bool replace_file(Temporary& written, const fs::path& path, std::string& why) {
    const fs::path target = link_target(path);
    log_output(path);
    log_output(target);
    log_output(written.path());
    std::error_code error;
    if (is_special(target))
        error =
            write_special(target, [&](auto write) { return each_block(written.path(), write); });
    else if (!hold_the_same(written.path(), target))
        error = written.place(target);
    written.remove();
    if (error) why = sentence(error);
    return !error;
}

fs::path link_target(const fs::path& path) {
    constexpr int longest_chain = 40;  // same as the system's limit
    fs::path target = path;
    std::error_code error;
    for (int i = 0; i < longest_chain && fs::is_symlink(target, error); ++i) {
        const fs::path next = fs::read_symlink(target, error);
        if (error) break;
        target = target.parent_path() / next;  // an absolute `next` replaces the folder
    }
    return target;
}

fs::path real_path(const fs::path& path, std::error_code& error) {
    return fs::weakly_canonical(fs::absolute(path), error);
}

fs::path real_path(const fs::path& path) {
    if (path.empty()) return real_path(".");
    std::error_code error;
    fs::path real = real_path(path, error);
    return error ? path : real;
}

std::optional<fs::path> inside(const fs::path& root, const fs::path& path) {
    std::error_code error;
    const fs::path real_root = real_path(root, error);
    if (error) return {};
    fs::path real = real_path(path, error);
    if (error || *real.lexically_relative(real_root).begin() == "..") return {};
    return real;
}

fs::path path_from(const fs::path& folder, const fs::path& path) {
    fs::path normal = path.lexically_normal();
    fs::path relative = normal.lexically_relative(folder.lexically_normal());
    return relative.empty() || *relative.begin() == ".." ? normal : relative;
}

}  // namespace wrinkle
