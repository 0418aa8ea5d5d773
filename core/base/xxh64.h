// XXH64, a fast checksum (https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md, seed 0):
// damage goes unnoticed with a chance of 1 in 2^64. It is not a signature: other bytes with the
// same sum can be made on purpose. Many times faster than sha256().
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace wrinkle {

// The sum of bytes that come in pieces; more may follow after digest().
class Xxh64 {
public:
    void add(std::span<const std::byte> bytes);
    // 16 lower-case hexadecimal digits, as xxh64sum prints them.
    std::string digest() const;

private:
    static constexpr size_t stripe = 32;

    std::array<uint64_t, 4> lanes_ = {0x60ea27eeadc0b5d6, 0xc2b2ae3d27d4eb4f, 0,
                                      0x61c8864e7a143579};
    std::array<std::byte, stripe> rest_{};  // the first size_ % stripe of them
    uint64_t size_ = 0;                     // bytes added
};

}  // namespace wrinkle
