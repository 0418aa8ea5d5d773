// Hash of short strings (names, keys, ids) for in-memory tables. Results differ between machines.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

namespace wrinkle {

inline uint64_t text_hash(std::string_view text) {
    constexpr uint64_t factor = 0x9E3779B97F4A7C15U;
    const auto mixed = [](uint64_t hash, uint64_t word) {
        hash = (hash ^ word) * factor;
        return hash ^ hash >> 32;
    };
    const char* at = text.data();
    size_t left = text.size();
    uint64_t hash = left;
    for (; left >= sizeof hash; at += sizeof hash, left -= sizeof hash) {
        uint64_t word = 0;
        std::memcpy(&word, at, sizeof word);
        hash = mixed(hash, word);
    }
    uint64_t rest = 0;
    for (size_t i = 0; i < left; ++i)
        rest = rest << 8 | static_cast<unsigned char>(at[i]);
    return mixed(hash, rest);
}

}  // namespace wrinkle
