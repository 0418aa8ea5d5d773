#include "base/file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

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

bool is_special(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

bool holds(const fs::path& path, std::string_view bytes) {
    std::string ignored;
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return false;
    const auto old = read_file(path, ignored);
    return old && *old == bytes;
}

// One file on its way: written under a temporary name, then put in its place.
class Replacement {
public:
    explicit Replacement(const FileBytes& file) : file_(file), target_(link_target(file.path)) {}
    Replacement(Replacement&& other) noexcept
        : file_(other.file_),
          target_(std::move(other.target_)),
          temporary_(std::exchange(other.temporary_, {})) {}
    ~Replacement() {
        std::error_code ignored;
        if (!temporary_.empty()) fs::remove(temporary_, ignored);
    }

    bool write(std::string& why) {
        std::error_code error;
        if (fs::is_directory(target_, error)) {
            why = "cannot be written: it is a folder";
            return false;
        }
        if (is_special(target_) || holds(target_, file_.bytes)) return true;
        temporary_ = target_;
        temporary_ += ".tmp" + std::to_string(getpid());
        if (write_all(temporary_, file_.bytes)) return true;
        why = "cannot be written: " + reason();
        return false;
    }

    bool place(std::string& why) {
        if (is_special(target_)) {
            if (write_all(target_, file_.bytes)) return true;
            why = "cannot be written: " + reason();
            return false;
        }
        return temporary_.empty() || put(std::exchange(temporary_, {}), target_, why);
    }

    static bool put(const fs::path& written, const fs::path& target, std::string& why) {
        std::error_code error;
        const fs::file_status old = fs::status(target, error);
        if (fs::is_regular_file(old)) fs::permissions(written, old.permissions(), error);
        fs::rename(written, target, error);
        if (!error) return true;
        why = "cannot be written: " + error.message();
        fs::remove(written, error);
        return false;
    }

private:
    FileBytes file_;
    fs::path target_;
    fs::path temporary_;  // "": nothing to put in place
};

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
    Replacement file({path, bytes});
    return file.write(why) && file.place(why);
}

bool write_files(std::span<const FileBytes> files, std::string& why) {
    std::vector<Replacement> replacements;
    const auto name = [&](size_t i) { why = files[i].path.string() + ": " + why; };
    for (const FileBytes& file : files) {
        replacements.emplace_back(file);
        if (replacements.back().write(why)) continue;
        name(replacements.size() - 1);
        return false;
    }
    for (size_t i = 0; i < files.size(); ++i)
        if (!replacements[i].place(why)) {
            name(i);
            return false;
        }
    return true;
}

bool replace_file(const fs::path& written, const fs::path& path, std::string& why) {
    const fs::path target = link_target(path);
    const auto bytes = read_file(written, why);
    const bool in_place = bytes && (is_special(target) || holds(target, *bytes));
    if (bytes && !in_place) return Replacement::put(written, target, why);
    std::error_code ignored;
    fs::remove(written, ignored);
    return in_place && write_file(path, *bytes, why);
}

fs::path link_target(const fs::path& path) {
    constexpr int longest_chain = 40;  // the system's own limit
    fs::path target = path;
    std::error_code error;
    for (int i = 0; i < longest_chain && fs::is_symlink(target, error); ++i) {
        const fs::path next = fs::read_symlink(target, error);
        if (error) break;
        target = target.parent_path() / next;  // an absolute one stands alone
    }
    return target;
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
