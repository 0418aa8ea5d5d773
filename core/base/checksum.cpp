#include "base/checksum.h"

#include <nettle/base16.h>
#include <nettle/sha2.h>

#include <array>
#include <cstdint>
#include <cstdio>

namespace wrinkle {

std::string sha256(std::string_view bytes) {
    sha256_ctx state;
    sha256_init(&state);
    sha256_update(&state, bytes.size(), reinterpret_cast<const uint8_t*>(bytes.data()));
    std::array<uint8_t, SHA256_DIGEST_SIZE> digest;
    sha256_digest(&state, digest.size(), digest.data());
    std::string digits(BASE16_ENCODE_LENGTH(digest.size()), '0');
    base16_encode_update(digits.data(), digest.size(), digest.data());
    return digits;
}

std::string Xxh64::digest() const {
    char digits[2 * sizeof(XXH64_hash_t) + 1];
    std::snprintf(digits, sizeof digits, "%016llx",
                  static_cast<unsigned long long>(XXH64_digest(&state_)));
    return digits;
}

}  // namespace wrinkle
