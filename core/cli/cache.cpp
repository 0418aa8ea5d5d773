#include "cli/cache.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <vector>

#include "base/file.h"
#include "base/sha256.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view form = "wrinkle cache 2\n";
constexpr std::string_view temporary = ".tmp";
constexpr auto temporary_life = std::chrono::hours(1);
constexpr std::string_view digits = "0123456789abcdef";
constexpr size_t key_size = 64;

bool write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes.remove_prefix(static_cast<size_t>(written));
    }
    return true;
}

std::string sum_of(const std::string& key, std::string_view bytes) {
    return sha256(key + sha256(bytes));
}

struct Kept {
    fs::path path;
    fs::file_time_type used;
    uint64_t size = 0;
};

// The folder may hold other files of the user, for example with `--cache .`.
bool is_key(std::string_view name) {
    return name.size() == key_size && name.find_first_not_of(digits) == name.npos;
}

// Lists the entries in a folder and deletes old temporary files of entries.
std::vector<Kept> kept_in(const fs::path& folder) {
    std::vector<Kept> found;
    const auto now = fs::file_time_type::clock::now();
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        const size_t key_end = std::min(name.find(temporary), name.size());
        if (!is_key(std::string_view(name).substr(0, key_end))) continue;
        std::error_code gone;  // another process may prune concurrently
        Kept kept{entry->path(), entry->last_write_time(gone), 0};
        if (!gone) kept.size = entry->file_size(gone);
        if (gone) continue;
        if (key_end == name.size())
            found.push_back(std::move(kept));
        else if (now - kept.used > temporary_life)
            fs::remove(kept.path, gone);
    }
    return found;
}

}  // namespace

fs::path Cache::place(const std::string& key) const {
    return folder_ / key.substr(0, 1) / key;
}

std::optional<std::string> Cache::find(const std::string& key) const {
    const fs::path path = place(key);
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored) || fs::file_size(path, ignored) > limit_ / parts)
        return {};
    std::string why;
    auto bytes = read_file(path, why);
    constexpr size_t head = form.size() + key_size + 1;  // includes the hash and its newline
    if (!bytes || bytes->size() < head || !bytes->starts_with(form)) return {};
    const std::string sum = bytes->substr(form.size(), key_size);
    bytes->erase(0, head);
    if (sum_of(key, *bytes) != sum) return {};
    fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
    return bytes;
}

bool Cache::store(const std::string& key, std::string_view bytes, std::string& why) {
    const fs::path path = place(key);
    const auto failed = [&] {
        why = path.string() + ": " + std::strerror(errno);
        return false;
    };
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    std::string name = path.string() + std::string(temporary) + "XXXXXX";
    const int file = mkstemp(name.data());
    if (file < 0) return failed();
    const bool written = fchmod(file, 0644) == 0 && write_all(file, form) &&
                         write_all(file, sum_of(key, bytes) + "\n") && write_all(file, bytes);
    const bool closed = close(file) == 0;
    if (!written || !closed || rename(name.c_str(), path.c_str()) != 0) {
        failed();
        unlink(name.c_str());
        return false;
    }
    grown_[digits.find(key[0])] = true;
    return true;
}

void Cache::prune() {
    for (size_t i = 0; i < parts; ++i) {
        if (!grown_[i].exchange(false)) continue;
        std::vector<Kept> kept = kept_in(folder_ / std::string(1, digits[i]));
        std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) {
            return a.used != b.used ? a.used < b.used : a.path < b.path;
        });
        uint64_t size = 0;
        for (const Kept& each : kept)
            size += each.size;
        for (size_t k = 0; k < kept.size() && size > limit_ / parts; ++k) {
            std::error_code gone;
            fs::remove(kept[k].path, gone);
            size -= kept[k].size;
        }
    }
}

}  // namespace wrinkle::cli
