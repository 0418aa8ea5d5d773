// Error code of the last failed system call (errno).
#pragma once

#include <cerrno>
#include <system_error>

namespace wrinkle {

inline std::error_code last_error() {
    return {errno, std::generic_category()};
}

}  // namespace wrinkle
