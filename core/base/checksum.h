// Hashes of bytes. SHA-256 (FIPS 180-4) identifies contents. XXH64 is a checksum many times faster:
// it misses corruption with probability 2^-64, but collisions can be constructed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace wrinkle {

// Returns 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

// XXH64 with seed 0 of bytes given in pieces; add() may be called after digest(). Source:
// https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md
class Xxh64 {
public:
    void add(std::span<const std::byte> bytes);
    // Returns 16 lower-case hexadecimal digits, in the format of xxh64sum.
    std::string digest() const;

private:
    static constexpr size_t stripe = 32;

    std::array<uint64_t, 4> lanes_ = {0x60ea27eeadc0b5d6, 0xc2b2ae3d27d4eb4f, 0,
                                      0x61c8864e7a143579};
    std::array<std::byte, stripe> rest_{};  // the first size_ % stripe bytes are pending
    uint64_t size_ = 0;                     // bytes added
};

}  // namespace wrinkle
