// A folder of results, each in a file that is named by its key: the SHA-256 of all that it depends
// on.
//
// An entry is written under a temporary name and renamed, so readers and other writers see it whole
// or not at all, and a program that is killed leaves at most a temporary file, which goes when it
// is an hour old. It begins with the SHA-256 of its key and of the
// SHA-256 of its bytes. An entry counts as absent if
// it is damaged, was stored under another key, is not a regular file, or is larger than its folder
// may be; the next to be stored replaces it. Any number of programs and threads may share a folder.
//
// The entries are in 16 folders by the first digit of their key. Each may hold a sixteenth of the
// limit; the entries that were not used for the longest time go first. Files with names that are
// not those of entries are left alone.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wrinkle::cli {

class Cache {
public:
    static constexpr size_t parts = 16;

    Cache(std::filesystem::path folder, uint64_t limit)  // bytes
        : folder_(std::move(folder)), limit_(limit) {}

    // `key` is a sum as sha256() writes it.
    std::optional<std::string> find(const std::string& key) const;
    // False with the reason in `why`.
    bool store(const std::string& key, std::string_view bytes, std::string& why);
    // Brings the folders that grew back below the limit; when all is stored.
    void prune();

private:
    std::filesystem::path place(const std::string& key) const;

    std::filesystem::path folder_;
    uint64_t limit_;
    std::array<std::atomic<bool>, parts> grown_{};
};

// Strings as one, and back; nothing when the bytes are not what join_fields() makes.
std::string join_fields(const std::vector<std::string>& fields);
std::optional<std::vector<std::string>> split_fields(std::string_view bytes);

}  // namespace wrinkle::cli
