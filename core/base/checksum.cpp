#include "base/checksum.h"

#include <sha2.h>

#include <cstdint>
#include <cstdio>

namespace wrinkle {

std::string sha256(std::string_view bytes) {
    char digits[SHA256_DIGEST_STRING_LENGTH];
    return SHA256Data(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size(), digits);
}

std::string Xxh64::digest() const {
    char digits[2 * sizeof(XXH64_hash_t) + 1];
    std::snprintf(digits, sizeof digits, "%016llx",
                  static_cast<unsigned long long>(XXH64_digest(&state_)));
    return digits;
}

}  // namespace wrinkle
