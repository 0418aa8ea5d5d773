// Folder of cached results. The file of an entry is named by its cache key: the SHA-256 of all
// inputs. Entries are written atomically (base/temporary.h), so any number of processes and threads
// may share a folder. An entry begins with a version line and SHA-256(key + SHA-256(bytes)) in
// hexadecimal.
//
// Entries are in 16 folders by the first digit of their key, each limited to a sixteenth of the
// total. Eviction is least recently used first. Files that are not named like entries are ignored.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace wrinkle::cli {

class Cache {
public:
    static constexpr size_t parts = 16;
    static constexpr uint64_t default_limit = uint64_t{1} << 30;  // bytes

    Cache(std::filesystem::path folder, uint64_t limit)  // bytes
        : folder_(std::move(folder)), limit_(limit) {}

    // `key` is a hash as sha256() returns it. Returns std::nullopt on a miss: no entry, or one that
    // is damaged, was stored under another key, is not a regular file, or is larger than the limit
    // of its folder. The next store() replaces it.
    std::optional<std::string> find(const std::string& key) const;
    // Returns false and the reason in `why` on failure.
    bool store(const std::string& key, std::string_view bytes, std::string& why);
    // Evicts entries of the folders that grew until they fit the limit. Call after all stores.
    void prune();

private:
    std::filesystem::path path_of(const std::string& key) const;

    std::filesystem::path folder_;
    uint64_t limit_;
    std::array<std::atomic<bool>, parts> grown_{};
};

}  // namespace wrinkle::cli
