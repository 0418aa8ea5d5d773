// SHA-256 (FIPS 180-4), to know the contents of a file again.
#pragma once

#include <string>
#include <string_view>

namespace wrinkle {

// 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace wrinkle
