// SHA-256 (FIPS 180-4), a hash that identifies file contents.
#pragma once

#include <string>
#include <string_view>

namespace wrinkle {

// Returns 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace wrinkle
