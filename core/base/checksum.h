// Hashes of bytes. SHA-256 (FIPS 180-4) identifies contents. XXH64 is a checksum many times faster:
// it misses corruption with probability 2^-64, but collisions can be constructed.
#pragma once

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace wrinkle {

// Returns 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

// XXH64 with seed 0.
inline uint64_t xxh64(std::string_view bytes) {
    return XXH64(bytes.data(), bytes.size(), 0);
}

// XXH64 with seed 0 of bytes given in pieces; add() may be called after digest().
class Xxh64 {
public:
    Xxh64() { XXH64_reset(&state_, 0); }
    void add(std::span<const std::byte> bytes) {
        XXH64_update(&state_, bytes.data(), bytes.size());
    }
    // Returns 16 lower-case hexadecimal digits, in the format of xxh64sum.
    std::string digest() const;

private:
    XXH64_state_t state_;
};

}  // namespace wrinkle
