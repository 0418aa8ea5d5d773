#include "cli/cache.h"

#include <algorithm>
#include <vector>

#include "base/checksum.h"
#include "base/file.h"

namespace wrinkle::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view form = "wrinkle cache 2\n";
constexpr std::string_view digits = "0123456789abcdef";
constexpr size_t key_size = 64;

std::string sum_of(const std::string& key, std::string_view bytes) {
    return sha256(key + sha256(bytes));
}

struct CacheFile {
    fs::path path;
    fs::file_time_type used;
    uint64_t size = 0;
};

// The folder may hold other files of the user, for example with `--cache .`.
bool is_key(std::string_view name) {
    return name.size() == key_size && name.find_first_not_of(digits) == name.npos;
}

std::vector<CacheFile> list_cache_files(const fs::path& folder) {
    std::vector<CacheFile> found;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
        if (!is_key(entry->path().filename().native())) continue;
        std::error_code gone;  // another process may prune concurrently
        CacheFile file{entry->path(), entry->last_write_time(gone), 0};
        if (!gone) file.size = entry->file_size(gone);
        if (!gone) found.push_back(std::move(file));
    }
    return found;
}

}  // namespace

fs::path Cache::path_of(const std::string& key) const {
    return folder_ / key.substr(0, 1) / key;
}

std::optional<std::string> Cache::find(const std::string& key) const {
    const fs::path path = path_of(key);
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
    const fs::path path = path_of(key);
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    auto file = Temporary::beside(path, error);
    if (file) error = file->write(std::string(form) + sum_of(key, bytes) + "\n");
    if (file && !error) error = file->write(bytes);
    if (file && !error) error = file->place(path);
    if (!file || error) {
        why = path.string() + ": " + error.message();
        return false;
    }
    grown_[digits.find(key[0])] = true;
    return true;
}

void Cache::prune() {
    for (size_t i = 0; i < parts; ++i) {
        if (!grown_[i].exchange(false)) continue;
        std::vector<CacheFile> files = list_cache_files(folder_ / std::string(1, digits[i]));
        std::ranges::sort(files, [](const CacheFile& a, const CacheFile& b) {
            return a.used != b.used ? a.used < b.used : a.path < b.path;
        });
        uint64_t size = 0;
        for (const CacheFile& each : files)
            size += each.size;
        for (size_t k = 0; k < files.size() && size > limit_ / parts; ++k) {
            std::error_code gone;
            fs::remove(files[k].path, gone);
            size -= files[k].size;
        }
    }
}

}  // namespace wrinkle::cli
